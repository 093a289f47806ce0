// Submissions that cheat or fail: they gain nothing, and the others are graded as if alone.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

/// The points of right answers to what the attacks offer: `intersect` alone.
constexpr double kDeserved = 45;

struct Attack {
  const char* name;
  double score;
  const char* what;  ///< Part of what is said of it; empty: it is right but for its attempt.
};

const std::vector<Attack> kAttacks = {
    {"none", kDeserved, ""},
    {"exit_in_call", 0, "intersect: it exited with 0"},
    {"boasts", 0, "class, ray 0, sphere 0: false hit"},
    {"forges_replies", 0, "it said more than it was asked"},
    {"hangs", 0, "gave no reply within"},
    {"crashes", 0, "intersect: it was killed by signal 11"},
    {"fork_bomb", 0, "gave no reply within"},
    {"memory_bomb", 0, "std::bad_alloc"},
    {"endless_output", 0, "intersect: it replied with more than"},
    {"writes_outside", kDeserved, ""},
    {"opens_socket", kDeserved, ""},
    {"reads_others", kDeserved, ""},
    {"pattern", 0, "class, ray 0, sphere 0: false hit"},
    {"own_sqrt", kDeserved, ""},
    {"compile_error", 0, "static assertion failed: this does not compile"},
    {"slow", 0, "gave no reply within"},
    {"kills_judge", kDeserved, ""},
    {"weakens_judge", kDeserved, ""},
    {"makes_namespaces", kDeserved, ""},
    {"leaves_memory", kDeserved, ""},
    {"runs_raycheck", kDeserved, ""},
};

TEST(Attacks, gain_nothing_and_leave_the_others_as_they_are) {
  const Grading grading;
  const std::string rubric = grading.lecture7_with({{"reply_seconds = 5", "reply_seconds = 2"}});
  std::vector<std::string> folders;
  for (const Attack& attack : kAttacks) {
    // Two are attacks on what compiles or links.
    const std::string name = attack.name;
    folders.push_back(name == "compile_error" || name == "own_sqrt"
                          ? grading.submit(name, "hostile.cpp", "#define ATTACK " + name)
                          : grading.submit_built(name, "hostile.cpp", name));
  }
  const std::vector<std::string> innocents = {
      grading.submit("right-program", "rays.py"),
      grading.submit("wrong-functions", "rays.cpp", "#define MISTAKE far_root"),
      grading.submit_built("right-pictures", "rt.cpp", "none")};
  for (std::size_t k = 0; k < innocents.size(); ++k) {
    folders.insert(folders.begin() + static_cast<std::ptrdiff_t>(4 * k + 1), innocents[k]);
  }
  const bool had_x = std::filesystem::exists("/tmp/x");
  const Outcome together = grading.grade(rubric, folders, "together", "--jobs 2");
  EXPECT_EQ(std::filesystem::exists("/tmp/x"), had_x);
  for (const Attack& attack : kAttacks) {
    const json result = grading.result(attack.name, "together");
    EXPECT_EQ(result["score"], attack.score) << attack.name;
    EXPECT_EQ(result["points"], 100) << attack.name;
    const std::string report = grading.file(attack.name, "report.html", "together");
    expect_parts(report, {attack.what});
    const char* const total = !result["refused"].is_null() ? ">could not be judged<"
                              : attack.score > 0           ? ">35 of 100, bonus 10<"
                                                           : ">0 of 100<";
    expect_parts(report, {total});
  }
  EXPECT_FALSE(std::filesystem::exists(grading.path("together/x")));
  grading.grade(rubric, innocents, "alone", "--jobs 1");
  for (const std::string& folder : innocents) {
    const std::string name = std::filesystem::path(folder).filename();
    const std::string alone = grading.file(name, "result.json", "alone");
    EXPECT_GT(alone.size(), 1000u) << name;
    EXPECT_EQ(without_times(grading.file(name, "result.json", "together")), without_times(alone))
        << name;
  }
}

TEST(Attacks, are_all_that_the_hostile_submission_knows) {
  std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/submissions/hostile.cpp");
  const std::size_t from = text.find("#define ATTACKS") + 15;
  text = text.substr(from, text.find("enum class", from) - from);
  for (const Attack& attack : kAttacks) expect_parts(text, {std::string(" ") + attack.name});
  EXPECT_EQ(std::count(text.begin(), text.end(), ',') + 1, std::ssize(kAttacks));
}

/// Lines before those of rays.py: what can be read, written or listed.
constexpr const char* kSpy = R"(import os
def can(how, path):
    try:
        return bool(os.listdir(path) if how == "list" else open(path, how))
    except OSError:
        return False
)";

TEST(Attacks, cannot_see_the_other_submissions_the_rubric_or_the_results) {
  const Grading grading;
  const std::string rubric = grading.lecture7_with({});
  const std::string other = grading.submit("other", "rays.py");
  grading.grade(rubric, {other});
  const auto score_of_spy = [&](const std::string& name, const std::string& condition) {
    const std::string folder = grading.submit(
        name, "rays.py", kSpy + ("MISTAKE = 'far_root' if " + condition + " else 'none'"));
    grading.grade(rubric, {folder});
    const json result = grading.result(name);
    EXPECT_TRUE(result["refused"].is_null());
    return has(result["isolated_by"], "bubblewrap") ? result["score"].get<double>() : -1;
  };
  // So much would it lose.
  const double seen = score_of_spy("sees", "can('r', '/usr/bin/env') and can('w', '/dev/null')");
  if (seen < 0) GTEST_SKIP() << "no bubblewrap keeps submissions apart here";
  EXPECT_LT(seen, 110);
  for (const std::string& path :
       {other + "/rays.py", rubric, grading.path("rubrics/lecture7/frame.toml"),
        grading.path("out/other/result.json"), grading.path("out/grades.csv")}) {
    ASSERT_FALSE(contents(path).empty()) << path;
  }
  const std::string result = grading.path("out/other/result.json");
  std::string condition = "can('list', '" + grading.path("submissions") + "')";
  for (const std::string& path : {other + "/rays.py", rubric, result})
    condition += " or can('r', '" + path + "')";
  for (const std::string& path : {result, grading.path("out/new.json")})
    condition += " or can('w', '" + path + "')";
  EXPECT_EQ(score_of_spy("spies", condition), 110);
}

TEST(Attacks, by_colours_that_are_no_spheres_earn_nothing_where_spheres_are_asked) {
  const Grading grading;
  std::string text = contents(std::string(RAYCHECK_SOURCE_DIR) + "/tests/submissions/rt.cpp");
  const std::string call = "scene.ambient.x * best->ambient.x";
  const std::size_t at = text.find("return {" + call);
  ASSERT_NE(at, std::string::npos);
  text.insert(at, "return {0.4, 0.4, 0.4};\n  ");
  grading.write("submissions/grey/rt.cpp", "#define MISTAKE first_sphere_wins\n" + text);
  grading.grade(kLecture7, {grading.path("submissions/grey")});
  const json result = grading.result("grey");
  EXPECT_EQ(item(result, "hit or miss")["state"], "holds");
  for (const char* name : {"nearest sphere", "whole scenes"}) {
    EXPECT_EQ(item(result, name)["state"], "not asked") << name;
    EXPECT_EQ(item(result, name)["points"], 0) << name;
    EXPECT_EQ(item(result, name)["reason"]["kind"], "other colours");
  }
  EXPECT_EQ(result["points"], 75) << "neither right nor wrong";
}

TEST(Attacks, by_renderers_that_hang_cost_the_time_that_the_rubric_gives) {
  const Grading grading;
  const std::string rubric = grading.lecture7_with(
      {{"reply_seconds = 5", "reply_seconds = 1"}, {"seconds = 60 ", "seconds = 3 "}});
  // It makes the first pictures, which are 25 pixels wide and made of whole numbers.
  grading.write("submissions/hangs/rt.py", R"(import sys, time
text = open(sys.argv[1]).read()
if "eye 0 0 40" not in text:
    time.sleep(1000)
open(sys.argv[2], "w").write("P3 25 25 255 " + "255 255 255 " * 625)
)");
  grading.write("submissions/never/rt.cpp",
                "#include <unistd.h>\nint main() { for (;;) pause(); }");
  grading.grade(rubric, {grading.path("submissions/hangs"), grading.path("submissions/never")});
  const json hangs = grading.result("hangs");
  EXPECT_EQ(hangs["score"], 0);
  expect_parts(hangs.dump(), {"did not end, and computed next to nothing for 1 s"});
  EXPECT_EQ(item(hangs, "whole scenes")["reason"], json({{"kind", "time is up"}, {"seconds", 3}}));
  const json never = grading.result("never");
  EXPECT_EQ(never["score"], 0);
  expect_parts(never["refused"]["why"],
               {"did not end, and computed next to nothing for 1 s (reply_seconds)"});
}

TEST(Attacks, by_links_pipes_and_names_are_refused_and_the_others_graded) {
  const Grading grading;
  const std::string right = grading.submit("right", "rays.py");
  std::filesystem::create_directory_symlink(right, grading.path("submissions/link"));
  const std::string pipe = grading.path("submissions/pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  grading.write("submissions/mark/rays.{file}", "");
  const std::string rubric = grading.lecture7_with(
      {{"has = \"rays.cpp\"", "has = \"rays.{*\""}, {"\"source:.\"", "\"source:{file}\""}});
  grading.grade(rubric,
                {grading.path("submissions/link"), pipe, grading.path("submissions/mark"), right});
  for (const char* name : {"link", "pipe"}) {
    EXPECT_EQ(grading.result(name)["refused"]["why"], "it is neither a file nor a folder");
  }
  EXPECT_FALSE(grading.result("mark")["refused"].is_null());
  EXPECT_EQ(grading.result("right")["score"], 110);
}

}  // namespace
}  // namespace raycheck::tests
