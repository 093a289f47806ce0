// SARIF, as GitHub's code scanning reads it: of gates, and of runs of candidates that die at known
// lines.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/tools/limited_run.h"
#include "tests/tools/program.h"
#include "tools/gates/gate_views.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;
using tools::Gate;
using tools::GateOutcome;
namespace fs = std::filesystem;

bool matches(const std::string& text, const std::string& pattern) {
  static std::map<std::string, std::regex> known;
  return std::regex_search(text, known.try_emplace(pattern, pattern).first->second);
}

/// What in a JSON value is not as a schema has it, in words; empty where all is. Of JSON Schema it
/// knows the words that sarif.schema.json uses; a key that `properties` does not name is an error.
std::string defect_of(const json& value, const json& schema, const std::string& at = "") {
  const auto is = [&](const std::string& type) {
    return type == "object"    ? value.is_object()
           : type == "array"   ? value.is_array()
           : type == "integer" ? value.is_number_integer()
                               : value.is_string();
  };
  if (schema.contains("enum")) {
    const json& values = schema["enum"];
    return std::find(values.begin(), values.end(), value) != values.end() ? "" : at + ": other";
  }
  if (!is(schema.at("type"))) return at + ": not of type " + schema["type"].get<std::string>();
  if (value.is_string() && schema.contains("pattern") &&
      !matches(value.get<std::string>(), schema["pattern"].get<std::string>())) {
    return at + ": does not match";
  }
  if (value.is_number() && value < schema.value("minimum", 0)) return at + ": too small";
  if (value.is_array()) {
    if (value.size() < schema.value("minItems", std::size_t{0})) return at + ": too few";
    if (value.size() > schema.value("maxItems", value.size())) return at + ": too many";
    for (const json& item : value) {
      if (auto why = defect_of(item, schema.at("items"), at + "[]"); !why.empty()) return why;
    }
  }
  if (!value.is_object()) return "";
  for (const json& key : schema.at("required")) {
    if (!value.contains(key)) return at + "/" + key.get<std::string>() + ": is missing";
  }
  for (const auto& [key, member] : value.items()) {
    if (!schema.at("properties").contains(key)) return at + "/" + key + ": is not known";
    const std::string why = defect_of(member, schema["properties"][key], at + "/" + key);
    if (!why.empty()) return why;
  }
  return "";
}

/// The same of a SARIF log, or what in it does not fit together.
std::string defect_of_log(const json& log) {
  static const json schema =
      json::parse(contents(RAYCHECK_SOURCE_DIR "/tests/tools/gates/sarif.schema.json"));
  if (std::string why = defect_of(log, schema); !why.empty()) return why;
  const json& run = log["runs"][0];
  for (const json& result : run["results"]) {
    const json& rules = run["tool"]["driver"]["rules"];
    if (result["ruleIndex"] >= rules.size()) return "a rule that is not there";
    if (rules[result["ruleIndex"].get<std::size_t>()]["id"] != result["ruleId"]) {
      return "another rule than its index says";
    }
  }
  return "";
}

/// A gate of so many failures, each at a line of its own.
Gate gate_at_lines(std::size_t failures, const std::string& text, const std::string& file) {
  Gate gate;
  gate.command = "check";
  for (std::size_t k = 0; k < failures; ++k) {
    const tools::Identity one = {"class", "rays", "refusal: failed", std::to_string(k), "mine"};
    const properties::CodeLine line = {file, static_cast<std::int64_t>(k + 1), 3, text};
    const std::string name = "class/" + std::to_string(k);
    gate.checks.push_back(
        {"mine", name, GateOutcome::kFailed, text, text, {one}, {{one, text + "\n", line}}});
  }
  tools::complete(gate, false);
  return gate;
}

TEST(Sarif, HasWhatGitHubAsksForOfEachLine) {
  const json log = json::parse(sarif(gate_at_lines(3, "why", "src/my tracer.cpp")));
  EXPECT_EQ(defect_of_log(log), "");
  const json& results = log["runs"][0]["results"];
  ASSERT_EQ(results.size(), 3u);
  std::set<std::string> fingerprints;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const json& place = results[k]["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "src/my%20tracer.cpp");
    EXPECT_EQ(place["artifactLocation"]["uriBaseId"], "%SRCROOT%");
    EXPECT_EQ(place["region"]["startLine"], k + 1);
    fingerprints.insert(results[k]["partialFingerprints"]["primaryLocationLineHash"]);
  }
  EXPECT_EQ(fingerprints.size(), 3u);
}

/// Of what is missing, and of what is other than it may be, a defect is seen.
TEST(Sarif, IsHeldToASchemaThatSeesWhatIsMissingOrOther) {
  const json right = json::parse(sarif(gate_at_lines(2, "why", "tracer.cpp")));
  ASSERT_EQ(defect_of_log(right), "");
  const json all = right.flatten();
  for (const auto& [where, value] : all.items()) {
    json other = right;
    other[json::json_pointer(where)] = json::object();
    EXPECT_NE(defect_of_log(other), "") << where;
  }
  const std::string run = "/runs/0", result = run + "/results/0",
                    place = result + "/locations/0/physicalLocation",
                    line = place + "/region/startLine", uri = place + "/artifactLocation/uri";
  for (const auto& [where, value] : std::vector<std::pair<std::string, json>>{
           {result + "/ruleId", "another"},
           {result + "/ruleIndex", 7},
           {result + "/message/text", ""},
           {result + "/locations", json::array()},
           {line, 0},
           {uri, "a b"},
           {uri, "/root.cpp"},
           {result + "/more", "than is known"},
           {"/version", nullptr},
           {"/runs", nullptr},
           {run + "/tool", nullptr},
           {run + "/results", nullptr},
           {result + "/ruleId", nullptr},
           {uri, nullptr},
           {line, nullptr},
           {result + "/partialFingerprints/primaryLocationLineHash", nullptr}}) {
    json other = right;
    const json::json_pointer pointer(where);
    other[pointer] = value;
    if (value.is_null()) other[pointer.parent_pointer()].erase(pointer.back());
    EXPECT_NE(defect_of_log(other), "") << where << " " << value;
  }
}

TEST(Sarif, KnowsALineAgainWhereItHasMoved) {
  const auto fingerprint = [](std::int64_t line, const std::string& text) {
    Gate gate = gate_at_lines(1, "why", "tracer.cpp");
    gate.checks[0].failed[0].line = {"tracer.cpp", line, 3, text};
    return json::parse(sarif(gate))["runs"][0]["results"][0]["partialFingerprints"];
  };
  EXPECT_EQ(fingerprint(3, "x / y"), fingerprint(30, "x / y"));
  EXPECT_NE(fingerprint(3, "x / y"), fingerprint(3, "x / z"));
}

TEST(Sarif, HasALineOnceHoweverManyChecksFailThere) {
  Gate gate = gate_at_lines(9, "why", "tracer.cpp");
  for (std::size_t k = 0; k < 9; ++k) gate.checks[k].failed[0].line->line = 7;
  const json results = json::parse(sarif(gate))["runs"][0]["results"];
  ASSERT_EQ(results.size(), 1u);
  EXPECT_TRUE(has(results[0]["message"]["text"].get<std::string>(),
                  "fails there: class/0, class/1, class/2, class/3, class/4 and 4 more"))
      << results[0];
}

TEST(Sarif, LeavesOutWhatIsKnownAndSaysWhatHasNoLine) {
  Gate gate = gate_at_lines(4, "why", "tracer.cpp");
  gate.ratchet.emplace();
  gate.ratchet->known = gate.checks[0].defects;
  gate.checks[1].failed[0].line.reset();
  gate.checks[2].failed.clear();
  EXPECT_EQ(json::parse(sarif(gate))["runs"][0]["results"].size(), 1u);
  const std::vector<std::string> warnings = sarif_warnings(gate);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].find("2 of 3 defects not in the SARIF log: 1 wrong answer, which no one "
                             "line makes; 1 failure at no line"),
            0u)
      << warnings[0];
  EXPECT_TRUE(sarif_warnings(gate_at_lines(2, "why", "tracer.cpp")).empty());
}

TEST(HostileSarif, HasNoMoreResultsThanGitHubTakesAndSaysSo) {
  const Gate gate = gate_at_lines(25'001, "why", "tracer.cpp");
  const json log = json::parse(sarif(gate));
  EXPECT_EQ(log["runs"][0]["results"].size(), 25'000u);
  ASSERT_EQ(sarif_warnings(gate).size(), 1u);
  EXPECT_EQ(sarif_warnings(gate)[0], "the SARIF log has the first 25000 of 25001 lines");
}

TEST(HostileSarif, KeepsTextsOfOthersInTheirStrings) {
  const std::string hostile =
      "\"}],\"x\":[{\n::error::mine\n##[error]mine\x1b[31m\x01\xff \u202e</script>";
  const std::string text = sarif(gate_at_lines(1, hostile, "\"a\n%41\xff: b.cpp"));
  EXPECT_EQ(defect_of_log(json::parse(text)), "") << text;
  EXPECT_FALSE(has(text, "\x1b"));
}

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
  static std::string checked() {
    return "check scene/examples/lecture-examples.toml --format sarif --candidate ";
  }
  std::string source() const { return "source:" + folder_ + "/tracer.cpp"; }

  const TestFolder its_;
  const std::string folder_ = its_.path();
};

TEST_F(SarifOfARun, OfPropertiesHasALineOnceAndNoneThatIsKnown) {
  const std::string asked = "properties --filter root --cases 4 --source rays --candidate " +
                            source() + " --report sarif=" + folder_;
  const Outcome outcome = run(asked + "/found.sarif --format json", 1);
  const json log = json::parse(contents(folder_ + "/found.sarif"));
  EXPECT_EQ(defect_of_log(log), "");
  ASSERT_EQ(log["runs"][0]["results"].size(), 1u) << log.dump(2);
  const std::string text = log["runs"][0]["results"][0]["message"]["text"];
  EXPECT_TRUE(has(text, "replay: raycheck properties --candidate"));
  EXPECT_TRUE(has(text, "fails there: nearest-root/rays"));
  const std::string baseline = " --baseline " + folder_ + "/known";
  run(asked + "/first.sarif --update-baseline" + baseline);
  const Outcome known = run(asked + "/known.sarif" + baseline, 0);
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
  const Outcome outcome = run(checked() + source(), 1);
  const json log = json::parse(outcome.out);
  EXPECT_EQ(defect_of_log(log), "");
  EXPECT_TRUE(log["runs"][0]["results"].empty());
  EXPECT_TRUE(std::regex_search(outcome.err, std::regex("^warning: ([0-9]+) of \\1 defects? not in "
                                                        "the SARIF log: \\1 wrong answers?, which "
                                                        "no one line makes\n$")))
      << outcome.err;
}

TEST_F(SarifOfARun, IsRefusedWhereNoLineCanBeKnown) {
  const auto refused = [](const std::string& arguments, const std::string& why) {
    expect_refused(arguments, why);
    expect_refused(arguments, "take junit, markdown, github or gitlab-codequality");
  };
  const std::string own = "raycheck's own methods are not of a source of yours";
  for (const std::string command :
       {"check scene/examples/lecture-examples.toml", "properties --cases 20"}) {
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
