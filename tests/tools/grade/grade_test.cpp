// Right submissions, reproducible grades, interrupted runs, and submissions like those of a class
// (tests/submissions/class), which get the scores and sentences in class.toml.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

constexpr double kFull = 110;  // with the bonus

/// The number of seeds.
int seeds() {
  const char* given = std::getenv("RAYCHECK_GRADE_SEEDS");
  return given != nullptr ? std::atoi(given) : 2;
}

TEST(RightSubmission, has_full_marks_under_every_seed) {
  const Grading grading;
  ASSERT_GT(seeds(), 1);
  const std::string rubric = grading.lecture7_with({});
  // Submissions that grading compiles are tried only with the first seed.
  std::vector<std::string> folders = {
      grading.submit("source", "rays.cpp"), grading.submit_built("renderer", "rt.cpp", "none"),
      grading.submit("mine", "rays.py"), grading.submit_built("so", "right.cpp", "right")};
  for (int seed = 1; seed <= seeds(); ++seed) {
    const json report = json::parse(
        grading.grade(rubric, folders, "out", "--format json --seed " + std::to_string(seed)).out);
    ASSERT_EQ(report["submissions"].size(), folders.size());
    for (const json& one : report["submissions"]) {
      EXPECT_EQ(one["score"], kFull) << "seed " << seed << "\n" << one.dump(2);
      EXPECT_EQ(one["points"], 100);
      EXPECT_EQ(one["seed"], seed);
    }
    if (seed == 1) folders[0] = grading.submit_built("functions", "rays.cpp", "none");
  }
}

/// Submissions in Python whose functions always miss, and their declarations.
std::string degenerate(const Grading& grading, const std::string& name,
                       const std::string& more = "") {
  return grading.hand_in(name, "rays.py",
                         "import raycheck_candidate as rc\n"
                         "rc.run('degenerate', intersect=lambda ray, sphere, asked: None" +
                             more + ")\n");
}

class DegenerateSubmission : public GradingTest {};

/// At exact tangents both hit classes are excused by a witness.
TEST_F(DegenerateSubmission, gets_no_points_if_every_answer_is_excused) {
  const std::string rubric =
      grading.write("tangents.toml",
                    kFormOfPython + item_of("tangents", "points = 10\ntolerance = { ulp = 16 }",
                                            functions("class", "tangent-ulps@53", 20, kGivenRays)));
  grading.grade(rubric, {degenerate(grading, "misses")});
  const json item = grading.result("misses")["items"][0];
  EXPECT_EQ(item["score"], 0) << item.dump(2);
  expect_values(item,
                {{"state", "fails"}, {"reason/kind", "never right"}, {"reason/quantity", "class"}});
}

/// Declared lengths or valid roots would exclude the rubric's cases.
TEST_F(DegenerateSubmission, gets_no_points_by_declaring_a_domain_without_cases) {
  const std::string rubric = grading.write(
      "rays.toml", kFormOfPython +
                       item_of("hits", "points = 10", functions("class", "rays", 20, kGivenRays)) +
                       item_of("frames", "points = 10", functions("frame", "cameras", 20)));
  const std::vector<std::string> states = {"lengths=(1e-300, 1e-9)", "lengths=(1e290, 1e300)",
                                           "roots=rc.Roots('[]', 1e300, 2e300, 'absolute', 'none')",
                                           "roots=rc.Roots('()', 0, 1e-300, 'radius', 'none')"};
  std::vector<std::string> submissions;
  for (const std::string& stated : states) {
    submissions.push_back(
        degenerate(grading, "degenerate" + std::to_string(submissions.size()),
                   ", frame=lambda camera: ((0, 0, 1), (0, 1, 0), (1, 0, 0)), " + stated));
  }
  const json report =
      json::parse(grading.grade(rubric, submissions, "out", "--format json --seed 1").out);
  ASSERT_EQ(report["submissions"].size(), states.size());
  for (const json& submission : report["submissions"]) {
    for (const json& item : submission["items"]) {
      EXPECT_EQ(item["state"], "fails") << item.dump(2);
      EXPECT_EQ(item["score"], 0);
    }
  }
}

/// This holds only for bonus items: in ordinary items, cases without hits may count.
TEST_F(DegenerateSubmission, gets_no_bonus_by_always_missing) {
  const std::string rubric = grading.write(
      "bonus.toml", kFormOfPython + item_of("rays", "points = 10\nbonus = true\ncredit = \"share\"",
                                            functions("class", "rays", 60, kGivenRays)));
  grading.grade(rubric, {degenerate(grading, "misses")});
  const json result = grading.result("misses");
  EXPECT_EQ(result["score"], 0) << result.dump(2);
  EXPECT_GT(result["items"][0]["cases"], 0);
}

TEST(RightSubmission, may_be_a_file_or_lie_in_a_nested_folder) {
  const Grading grading;
  const std::string deep = grading.submit("deep/unpacked/src", "rays.py");
  grading.grade(grading.short_rubric("", kNearestRoot),
                {grading.path("submissions/deep"), deep + "/rays.py"});
  for (const char* name : {"deep", "rays"}) EXPECT_EQ(grading.result(name)["score"], 10) << name;
}

TEST(Rubric, that_raychecks_own_methods_fail_ends_with_1) {
  const Grading grading;
  const std::string rubric =
      grading.write("rubric.toml", item_of("beyond doubles", "points = 1\ntolerance = { ulp = 0 }",
                                           functions("direction", "course", 20)));
  const Outcome outcome = run("grade '" + rubric + "'", 1);
  expect_parts(outcome.err, {"beyond doubles: raycheck's own methods do not get all points"});
}

class Grades : public GradingTest {};

/// The first build waits for the last one.
TEST_F(Grades, do_not_wait_for_a_slow_build) {
  const std::string last = "'" + grading.path("last") + "'";
  std::vector<std::string> folders;
  for (int k = 0; k < 9; ++k) {
    const std::string does = k == 0 ? "for k in $$(seq 300); do test -e " + last +
                                          " && break; sleep 0.1; done; test -e " + last
                             : k == 8 ? "touch " + last
                                      : ":";
    folders.push_back(grading.hand_in("s" + std::to_string(k), "Makefile",
                                      "rt:\n\t" + does + "\n\tprintf '#!/bin/sh\\n' > rt\n"));
    grading.write("submissions/s" + std::to_string(k) + "/rt.py", renderer_in_python());
  }
  const std::string rubric = grading.write(
      "own.toml",
      replaced(replaced(full_rubric(1), "\"auto\"", "\"make\""), "{program}", "python3 rt.py"));
  const json report = json::parse(
      grading.grade(rubric, folders, "out", kLimitsOnly + std::string("--format json --jobs 2"))
          .out);
  ASSERT_EQ(report["submissions"].size(), folders.size());
  for (std::size_t k = 0; k < folders.size(); ++k) {
    EXPECT_EQ(report["submissions"][k]["name"], "s" + std::to_string(k));
    EXPECT_EQ(report["submissions"][k]["score"], 10) << report["submissions"][k].dump(2);
  }
}

TEST_F(Grades, are_the_same_bytes_for_any_number_of_jobs_and_with_stored_answers) {
  // One quick submission of every kind.
  const std::vector<std::string> folders = {
      grading.submit_built("far-root", "rays.cpp", "far_root"),
      grading.submit_built("mirrored", "rt.cpp", "mirrored"),
      grading.submit_built("crashes", "hostile.cpp", "crashes"),
      grading.submit_broken("does-not-compile"),
      grading.submit("axes", "rays.py", "MISTAKE = \"axes_dropped\"")};
  const auto graded = [&](const std::string& points, const std::string& out,
                          const std::string& jobs) {
    const std::string frame = functions("frame", "course", 6) + pictures("lecture7/frame.toml");
    const std::string rubric = grading.short_rubric(
        "", item_of("frame", "points = " + points, frame) + kPixelZeroZero + kNearestRoot);
    grading.grade(rubric, folders, out, "--jobs " + jobs);
  };
  graded("15", "stored", "1");
  graded("14", "stored", "1");
  graded("14", "anew", "2");
  for (const std::string& folder : folders) {
    const std::string name = fs::path(folder).filename();
    for (const char* file : {"result.json", "report.html"}) {
      const std::string text = grading.file(name, file, "stored");
      EXPECT_GT(text.size(), 500u) << name << "/" << file;
      EXPECT_EQ(without_times(text), without_times(grading.file(name, file, "anew")))
          << name << "/" << file;
    }
  }
  for (const char* file : {"grades.csv", "index.html"}) {
    EXPECT_EQ(without_times(grading.file("", file, "stored")),
              without_times(grading.file("", file, "anew")));
  }
}

TEST_F(Grades, use_other_cases_for_each_seed_and_a_seed_per_submission_under_a_secret) {
  const std::string rubric = grading.short_rubric("", kNearestSphere);
  const std::vector<std::string> folders = {
      grading.submit_built("alice", "rays.cpp", "first_sphere_wins"),
      grading.submit_built("bob", "rays.cpp", "first_sphere_wins")};
  std::set<std::uint64_t> seeds;
  std::set<json> first_wrong;
  const auto grade_under = [&](const std::string& secret, const std::string& out) {
    grading.grade(rubric, folders, out, "--secret-file '" + grading.write(secret, secret) + "'");
    for (const char* name : {"alice", "bob"}) {
      const json result = grading.result(name, out);
      seeds.insert(result["seed"].get<std::uint64_t>());
      EXPECT_EQ(item(result, "nearest sphere")["state"], "fails");
      first_wrong.insert(item(result, "nearest sphere")["first_wrong"]);
    }
  };
  grade_under("hunter2", "one");
  grade_under("hunter2", "two");
  EXPECT_EQ(without_times(grading.file("bob", "result.json", "one")),
            without_times(grading.file("bob", "result.json", "two")));
  grade_under("hunter3", "three");
  EXPECT_EQ(seeds.size(), 4u);
  EXPECT_EQ(first_wrong.size(), 4u);
}

TEST_F(Grades, of_an_interrupted_run_are_finished_by_the_next) {
  const std::string rubric = grading.short_rubric("reply_seconds = 2\n", kNearestRoot);
  std::vector<std::string> folders = {grading.submit("far-root", "rays.py"),
                                      grading.submit_built("sleeps", "hostile.cpp", "slow"),
                                      grading.submit("last", "rays.py")};
  const auto first_is_graded = [&] {
    return has(grading.file("far-root", "result.json"), "\"finished\": true");
  };
  const Outcome cut =
      run_interrupted(grading.arguments(rubric, folders, "out", "--jobs 1"), first_is_graded);
  EXPECT_EQ(cut.exit_code, 130) << cut.err;
  expect_parts(cut.out, {"INTERRUPTED: run the same command again to continue."});
  expect_parts(grading.file("", "index.html"), {"Interrupted: "});
  expect_parts(grading.file("", "grades.csv"), {"\nfar-root,10,10"});
  const std::string last = grading.file("last", "result.json");
  EXPECT_TRUE(last.empty() || !json::parse(last)["finished"].get<bool>());
  grading.grade(rubric, folders, "out", "--jobs 1");
  grading.grade(rubric, folders, "whole", "--jobs 2");
  for (const char* name : {"far-root", "sleeps", "last"}) {
    const std::string whole = grading.file(name, "result.json", "whole");
    EXPECT_TRUE(json::parse(whole)["finished"]) << name;
    EXPECT_EQ(without_times(grading.file(name, "result.json")), without_times(whole)) << name;
    EXPECT_EQ(grading.file(name, "report.html"), grading.file(name, "report.html", "whole"));
  }
  EXPECT_EQ(grading.file("", "grades.csv"), grading.file("", "grades.csv", "whole"));
}

/// The entry of a submission in class.toml.
struct HandIn {
  std::string name;
  std::string language;
  bool is_right = false;
  double score = 0;
  std::vector<std::string> sentences;  ///< The sentences on failing items, each once, in order.
};

void PrintTo(const HandIn& hand_in, std::ostream* to) { *to << hand_in.name; }

/// The entries of class.toml, which Python reads.
const std::vector<HandIn>& hand_ins() {
  static const std::vector<HandIn> all = [] {
    const Outcome read = run_python(
        "-c \"import json, sys, tomllib; "
        "json.dump(tomllib.load(open(sys.argv[1], 'rb')), sys.stdout)\" "
        "tests/submissions/class/class.toml");
    std::vector<HandIn> list;
    const json table = json::parse(read.out);
    for (const json& one : table["hand_in"]) {
      list.push_back(
          {one["name"], one["language"], one["faults"].empty(), one["score"], one["says"]});
    }
    return list;
  }();
  return all;
}

bool is_runnable(const HandIn& hand_in) {
  return hand_in.language == "Java"         ? is_installed("javac")
         : hand_in.language == "JavaScript" ? is_installed("node")
                                            : true;
}

/// The whole class, graded in one run.
const Grading& graded_class() {
  static const Grading grading;
  [[maybe_unused]] static const bool is_graded = [] {
    std::vector<std::string> folders;
    for (const HandIn& one : hand_ins()) {
      if (is_runnable(one))
        folders.push_back(RAYCHECK_SOURCE_DIR "/tests/submissions/class/" + one.name);
    }
    grading.grade(kLecture7, folders, "out", kLimitsOnly);
    return true;
  }();
  return grading;
}

class EachHandIn : public testing::TestWithParam<HandIn> {};

TEST_P(EachHandIn, HasTheExpectedScoreAndSentences) {
  const HandIn& hand_in = GetParam();
  if (!is_runnable(hand_in)) GTEST_SKIP() << hand_in.language << " is not installed";
  const json result = graded_class().result(hand_in.name);
  EXPECT_NEAR(result["score"].get<double>(), hand_in.score, 0.005) << result.dump(2);
  if (hand_in.is_right) {
    EXPECT_GE(result["score"], result["points"]);
  }
  std::vector<std::string> said;
  for (const json& item : result["items"]) {
    if (item["state"] != "fails") continue;
    for (const json& mistake : item["mistakes"]) {
      const std::string sentence = mistake["sentence"];
      if (std::find(said.begin(), said.end(), sentence) == said.end()) said.push_back(sentence);
    }
  }
  EXPECT_EQ(said, hand_in.sentences) << result.dump(2);
}

INSTANTIATE_TEST_SUITE_P(Class, EachHandIn, testing::ValuesIn(hand_ins()),
                         [](const auto& the_test) { return the_test.param.name; });

}  // namespace
}  // namespace raycheck::tests
