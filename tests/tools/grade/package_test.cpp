// The zip file for Gradescope, unpacked and run as on Gradescope.

#include "tests/tools/external/machine.h"
#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// Unpacks with permissions, which Python's zipfile ignores.
constexpr const char* kUnpack = R"py(import os, sys, zipfile
for one in (archive := zipfile.ZipFile(sys.argv[1])).infolist():
    os.chmod(archive.extract(one, sys.argv[2]), one.external_attr >> 16 & 0o777 or 0o755)
)py";

/// A machine like Gradescope's: /autograder is the folder `root`, with a package in it.
class Package : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    own_ = std::make_unique<Grading>();
    const Grading& grading = *own_;
    rubric_ = grading.short_rubric("", kPixelZeroZero + kNearestRoot);
    package("autograder.zip");
    const std::string unpack = grading.write("unpack.py", kUnpack);
    run_python("'" + unpack + "' '" + grading.path("autograder.zip") + "' '" +
                   grading.path("root/source") + "'",
               0);
  }
  static void TearDownTestSuite() { own_.reset(); }

  /// With a seed, to check that the package contains it.
  static void package(const std::string& name) {
    const std::string zip = own_->path(name);
    EXPECT_EQ(run("grade '" + rubric_ + "' --seed 77 --package '" + zip + "'", 0).out,
              "wrote " + zip + "\n");
  }

  /// The output of a shell command run with an empty environment.
  std::string said_by(const std::string& words) const {
    const std::string root = grading.path("root");
    return run_bash("env -i PATH=/usr/local/bin:/usr/bin:/bin HOME='" + root +
                        "' RAYCHECK_AUTOGRADER='" + root + "' " + words + " 2>&1\n",
                    0)
        .out;
  }
  /// The results of run_autograder for this submission.
  json graded(const std::string& folder) const {
    fs::remove_all(grading.path("root/submission"));
    fs::remove_all(grading.path("root/results"));
    fs::copy(folder, grading.path("root/submission"), fs::copy_options::recursive);
    const std::string said = said_by("'" + grading.path("root/source/run_autograder") + "'");
    const std::string results = contents(grading.path("root/results/results.json"));
    EXPECT_FALSE(results.empty()) << said;
    return results.empty() ? json() : json::parse(results);
  }

  static std::unique_ptr<Grading> own_;
  static std::string rubric_;
  const Grading& grading = *own_;
};
std::unique_ptr<Grading> Package::own_;
std::string Package::rubric_;

TEST_F(Package, grades_submissions_as_raycheck_does) {
  const json right = graded(grading.submit("right", "rays.cpp"));
  EXPECT_EQ(right["score"], 14) << right.dump(2);
  EXPECT_EQ(right["tests"].size(), 2u);
  const json pictures = graded(grading.submit_built("pictures", "rt.cpp", "mirrored"));
  expect_parts(pictures.dump(), {"columns are mirrored"});
  const std::string wrong = grading.submit("submission", "rays.py", "MISTAKE = \"far_root\"");
  const json results = graded(wrong);
  grading.grade(rubric_, {wrong}, "out", "--seed 77 --format gradescope");
  EXPECT_EQ(results, json::parse(grading.file("submission", "results.json")));
  EXPECT_EQ(results["score"], 4);
  const json broken = graded(grading.submit_broken("broken"));
  EXPECT_EQ(broken["score"], 0);
  expect_parts(broken["output"], {"this does not compile"});
  const std::string folder = grading.path("root/source/rubric");
  fs::rename(folder, grading.path("away"));
  const json none = graded(wrong);
  fs::rename(grading.path("away"), folder);
  EXPECT_EQ(none["score"], 0);
  expect_parts(none["output"], {"raycheck could not grade this"});
}

TEST_F(Package, reports_missing_namespaces_in_a_container_and_grades) {
  if (std::system((std::string(kWithoutBubblewrap) + "true").c_str()) != 0) {
    GTEST_SKIP() << "bubblewrap cannot be hidden here";
  }
  fs::remove_all(grading.path("root/submission"));
  fs::copy(grading.submit("python", "rays.py"), grading.path("root/submission"),
           fs::copy_options::recursive);
  const std::string said =
      said_by(kWithoutBubblewrap + ("'" + grading.path("root/source/run_autograder") + "'"));
  expect_parts(said, {"; not by bubblewrap: "});
  EXPECT_EQ(json::parse(contents(grading.path("root/results/results.json")))["score"], 14) << said;
}

TEST_F(Package, contains_the_libraries_that_only_raycheck_needs) {
  static const std::regex of_the_system(
      "lib(c|m|dl|rt|pthread|gcc_s|stdc\\+\\+)\\.so\\.[0-9]|linux-vdso\\.so\\.1|.*/ld-linux-.*");
  const std::string bin = grading.path("root/source/raycheck/libexec/raycheck/");
  std::size_t brought = 0;
  for (const char* program : {"raycheck-grade", "raycheck-jail", "raycheck-worker"}) {
    for (const std::string& line : lines_of(said_by("ldd '" + bin + program + "'"))) {
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
  EXPECT_EQ(contents(grading.path("root/source/rubric/lecture7/behind.toml")),
            contents(RAYCHECK_SOURCE_DIR "/examples/rubrics/lecture7/behind.toml"));
}

TEST_F(Package, is_reproducible_and_contains_the_seed) {
  package("again.zip");
  EXPECT_EQ(contents(grading.path("again.zip")), contents(grading.path("autograder.zip")));
  expect_parts(contents(grading.path("root/source/run_autograder")), {"--seed 77 "});
}

}  // namespace
}  // namespace raycheck::tests
