// The zip file for Gradescope, unpacked and run as Gradescope does.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

#include "tests/tools/external/machine.h"
#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// With its permissions, which zipfile alone leaves out.
constexpr const char* kUnpack = R"py(import os, sys, zipfile
for one in (archive := zipfile.ZipFile(sys.argv[1])).infolist():
    os.chmod(archive.extract(one, sys.argv[2]), one.external_attr >> 16 & 0o777 or 0o755)
)py";

/// With a seed, so that no second file is needed to see that it is in it.
constexpr const char* kPackage = "grade examples/rubrics/lecture7.toml --seed 77 --package ";

/// A machine as Gradescope's: /autograder is the folder `root`.
class Package : public testing::Test {
 protected:
  void SetUp() override {
    const std::string zip = grading.path("autograder.zip");
    const Outcome written = run(std::string(kPackage) + "'" + zip + "'", 0);
    EXPECT_EQ(written.out, "wrote " + zip + "\n");
    const std::string unpack = grading.write("unpack.py", kUnpack);
    run_python("'" + unpack + "' '" + zip + "' '" + grading.path("root/source") + "'", 0);
  }

  /// The output of shell words, with nothing of this machine's environment.
  std::string said_by(const std::string& words, int exit_code = 0) const {
    const std::string out = grading.path("said");
    const std::string command = "env -i PATH=/usr/local/bin:/usr/bin:/bin HOME='" +
                                grading.path("root") + "' RAYCHECK_AUTOGRADER='" +
                                grading.path("root") + "' " + words + " >'" + out + "' 2>&1";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), exit_code) << words << "\n" << contents(out);
    return contents(out);
  }
  /// What run_autograder leaves of this submission.
  json graded(const std::string& folder) const {
    fs::remove_all(grading.path("root/submission"));
    fs::remove_all(grading.path("root/results"));
    fs::copy(folder, grading.path("root/submission"), fs::copy_options::recursive);
    const std::string said = said_by("'" + grading.path("root/source/run_autograder") + "'");
    const std::string results = contents(grading.path("root/results/results.json"));
    EXPECT_FALSE(results.empty()) << said;
    return results.empty() ? json() : json::parse(results);
  }

  const Grading grading;
};

TEST_F(Package, grades_submissions_as_raycheck_does) {
  const json right = graded(grading.submit("right", "rays.cpp"));
  EXPECT_EQ(right["score"], 110) << right.dump(2);
  EXPECT_EQ(right["tests"].size(), 11u);
  const json pictures = graded(grading.submit("pictures", "rt.cpp", "#define MISTAKE mirrored"));
  expect_parts(pictures.dump(), {"columns are mirrored"});
  const std::string wrong = grading.submit("submission", "rays.py", "MISTAKE = \"far_root\"");
  const json results = graded(wrong);
  grading.grade(kLecture7, {wrong}, "out", "--seed 77 --format gradescope");
  EXPECT_EQ(results, json::parse(grading.file("submission", "results.json")));
  EXPECT_LT(results["score"], 100);
  EXPECT_GT(results["score"], 0);
  const json broken =
      graded(grading.submit("broken", "hostile.cpp", "#define ATTACK compile_error"));
  EXPECT_EQ(broken["score"], 0);
  expect_parts(broken["output"], {"this does not compile"});
  fs::remove_all(grading.path("root/source/rubric"));
  const json none = graded(wrong);
  EXPECT_EQ(none["score"], 0);
  expect_parts(none["output"], {"raycheck could not grade this"});
}

TEST_F(Package, grades_in_a_container_without_namespaces_and_says_so) {
  if (std::system((std::string(kWithoutBubblewrap) + "true").c_str()) != 0) {
    GTEST_SKIP() << "bubblewrap cannot be hidden here";
  }
  fs::copy(grading.submit("right", "rays.py"), grading.path("root/submission"),
           fs::copy_options::recursive);
  const std::string said =
      said_by(kWithoutBubblewrap + ("'" + grading.path("root/source/run_autograder") + "'"));
  expect_parts(said, {"; not by bubblewrap: "});
  EXPECT_EQ(json::parse(contents(grading.path("root/results/results.json")))["score"], 110) << said;
}

TEST_F(Package, brings_the_libraries_that_only_raycheck_needs) {
  static const std::regex of_the_system(
      "lib(c|m|dl|rt|pthread|gcc_s|stdc\\+\\+)\\.so\\.[0-9]|linux-vdso\\.so\\.1|.*/ld-linux-.*");
  const std::string bin = grading.path("root/source/raycheck/libexec/raycheck/");
  std::size_t brought = 0;
  for (const char* program : {"raycheck-grade", "raycheck-jail", "raycheck-worker"}) {
    std::istringstream lines(said_by("ldd '" + bin + program + "'"));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string name, arrow, path;
      words >> name >> arrow >> path;
      if (std::regex_match(name, of_the_system)) continue;
      ++brought;
      const std::string place = fs::weakly_canonical(path).string();
      EXPECT_EQ(place.rfind(fs::canonical(grading.path("root/source/raycheck/lib")).string(), 0),
                0u)
          << line;
    }
  }
  EXPECT_GT(brought, 5u);
  EXPECT_EQ(said_by("'" + grading.path("root/source/raycheck/bin/raycheck") + "' rubric"),
            run("rubric").out);
}

TEST_F(Package, has_scripts_that_run_and_the_scenes_of_the_rubric) {
  for (const char* script : {"setup.sh", "run_autograder"}) {
    const std::string path = grading.path(std::string("root/source/") + script);
    EXPECT_EQ(contents(path).rfind("#!/usr/bin/env bash\n", 0), 0u) << script;
    EXPECT_NE(fs::status(path).permissions() & fs::perms::owner_exec, fs::perms::none) << script;
    EXPECT_EQ(said_by("bash -n '" + path + "'"), "");
  }
  EXPECT_EQ(contents(grading.path("root/source/rubric/lecture7/frame.toml")),
            contents(RAYCHECK_SOURCE_DIR "/examples/rubrics/lecture7/frame.toml"));
}

TEST_F(Package, is_the_same_bytes_each_time_and_holds_the_seed) {
  const std::string again = grading.path("again.zip");
  EXPECT_EQ(run(std::string(kPackage) + "'" + again + "'").exit_code, 0);
  EXPECT_EQ(contents(again), contents(grading.path("autograder.zip")));
  expect_parts(contents(grading.path("root/source/run_autograder")), {"--seed 77 "});
}

}  // namespace
}  // namespace raycheck::tests
