// SARIF of runs: of candidates that die at known lines, and of others.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "tests/tools/gates/sarif_schema.h"
#include "tests/tools/limited_run.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A candidate that divides by zero at line 7 whatever it is asked.
class SarifOfARun : public testing::Test {
 protected:
  SarifOfARun() {
    write("tracer.cpp",
          "#include <raycheck/candidate.hpp>\n"
          "using namespace raycheck;\n"
          "volatile int zero = 0;\n"
          "std::optional<Hit> intersect(const Ray&, const Sphere& sphere, const Conventions&) {\n"
          "  const int radius = static_cast<int>(sphere.radius);\n"
          "  // One line on:\n"
          "  zero = radius / zero;\n"
          "  return {};\n"
          "}\n"
          "RAYCHECK_CANDIDATE(.intersect = intersect)\n");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + "/" + name) << text;
  }
  std::string source() const { return "source:" + folder_ + "/tracer.cpp"; }

  const TestFolder its_;
  const std::string folder_ = its_.path();
};

const std::string kRays = "scene/examples/lecture-examples.toml";

TEST_F(SarifOfARun, OfCheckHasTheLineWhereItDies) {
  const Outcome outcome = run("check " + kRays + " --format sarif --candidate " + source());
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json log = json::parse(outcome.out);
  EXPECT_EQ(defect_of_log(log), "");
  const json& results = log["runs"][0]["results"];
  ASSERT_EQ(results.size(), 1u) << outcome.out;
  const json& place = results[0]["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["artifactLocation"]["uri"], "file://" + folder_ + "/tracer.cpp");
  EXPECT_EQ(place["region"]["startLine"], 7);
  EXPECT_EQ(place["region"]["startColumn"], 3);
  EXPECT_EQ(place["region"]["endColumn"], 3 + 21);
  EXPECT_EQ(place["region"]["snippet"]["text"], "zero = radius / zero;");
  EXPECT_NE(results[0]["message"]["text"].get<std::string>().find("tracer.cpp:7"),
            std::string::npos);
}

TEST_F(SarifOfARun, OfPropertiesHasALineOnceAndNoneThatIsKnown) {
  const std::string asked = "properties --filter root --cases 4 --source rays --candidate " +
                            source() + " --report sarif=" + folder_;
  const Outcome outcome = run(asked + "/found.sarif --format json");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json log = json::parse(contents(folder_ + "/found.sarif"));
  EXPECT_EQ(defect_of_log(log), "");
  ASSERT_EQ(log["runs"][0]["results"].size(), 1u) << log.dump(2);
  const std::string text = log["runs"][0]["results"][0]["message"]["text"];
  EXPECT_NE(text.find("replay: raycheck properties --candidate"), std::string::npos) << text;
  EXPECT_NE(text.find("fails there: nearest-root/rays"), std::string::npos) << text;
  const std::string baseline = " --baseline " + folder_ + "/known";
  run(asked + "/first.sarif --update-baseline" + baseline);
  const Outcome known = run(asked + "/known.sarif" + baseline);
  EXPECT_EQ(known.exit_code, 0) << known.out << known.err;
  const json nothing = json::parse(contents(folder_ + "/known.sarif"));
  EXPECT_EQ(defect_of_log(nothing), "");
  EXPECT_TRUE(nothing["runs"][0]["results"].empty());
}

TEST_F(SarifOfARun, OfWrongAnswersHasNoResultsAndSaysHowManyHaveNoLine) {
  write("tracer.cpp",
        "#include <raycheck/candidate.hpp>\n"
        "using namespace raycheck;\n"
        "std::optional<Hit> intersect(const Ray& ray, const Sphere&, const Conventions&) {\n"
        "  return Hit{1, ray.origin};\n"
        "}\n"
        "RAYCHECK_CANDIDATE(.intersect = intersect)\n");
  const Outcome outcome = run("check " + kRays + " --format sarif --candidate " + source());
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json log = json::parse(outcome.out);
  EXPECT_EQ(defect_of_log(log), "");
  EXPECT_TRUE(log["runs"][0]["results"].empty());
  EXPECT_TRUE(std::regex_search(outcome.err, std::regex("^warning: ([0-9]+) of \\1 defects? not in "
                                                        "the SARIF log: \\1 wrong answers?, which "
                                                        "no one line makes\n$")))
      << outcome.err;
}

TEST_F(SarifOfARun, IsRefusedWhereNoLineCanBeKnown) {
  const std::string others = "take junit, markdown, github or gitlab-codequality";
  const auto refused = [&](const std::string& arguments, const std::string& why) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    for (const std::string& words : {why, others}) {
      EXPECT_NE(outcome.err.find(words), std::string::npos) << arguments << "\n" << outcome.err;
    }
  };
  const std::string own = "raycheck's own methods are not of a source of yours";
  for (const std::string& command : {"check " + kRays, std::string("properties --cases 20")}) {
    refused(command + " --format sarif", "--format sarif: ");
    refused(command + " --report sarif=" + folder_ + "/x", "--report sarif: ");
    refused(command + " --format sarif", own);
    refused(command + " --format sarif --rays direct --candidate " + source(), own);
    for (const std::string other :
         {"'command:python3 tests/candidates/meets.py none'", "library:none.so"}) {
      refused(command + " --format sarif --candidate " + source() + " --candidate " + other,
              "none is known: raycheck did not compile it");
    }
  }
  EXPECT_FALSE(fs::exists(folder_ + "/x"));
}

}  // namespace
}  // namespace raycheck::tests
