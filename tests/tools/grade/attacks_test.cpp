// Submissions that cheat or fail get no points and do not change other grades.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// The points for right answers by `intersect`, the only function of the attacks, and the points of
/// all items.
constexpr double kDeserved = 10, kPoints = 29;

struct Attack {
  const char* name;
  double score;
  const char* what;  ///< Part of the report; empty if its answers are right despite the attempt.
};

const std::vector<Attack> kAttacks = {
    {"none", kDeserved, ""},
    {"exit_in_call", 0, "intersect: it exited with 0"},
    {"boasts", 0, "class, ray 0, sphere 0: false hit"},
    {"forges_replies", 0, "its first line is &#39;{&quot;score&quot;: 100}&#39;"},
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

std::string all_items() { return kPixelZeroZero + kNearestRoot + kNearestSphere; }

class Attacks : public GradingTest {};

TEST_F(Attacks, earn_no_points_and_do_not_change_other_grades) {
  const std::string rubric = grading.short_rubric("reply_seconds = 2\n", all_items());
  std::vector<std::string> folders;
  for (const Attack& attack : kAttacks) {
    // Two of them attack the compiler or linker.
    const std::string name = attack.name;
    folders.push_back(name == "compile_error" || name == "own_sqrt"
                          ? grading.submit(name, "hostile.cpp", "#define ATTACK " + name)
                          : grading.submit_built(name, "hostile.cpp", name));
  }
  const std::vector<std::string> innocents = {
      grading.submit("right-program", "rays.py"),
      grading.submit_built("wrong-functions", "rays.cpp", "far_root"),
      grading.submit_built("right-pictures", "rt.cpp", "none")};
  for (std::size_t k = 0; k < innocents.size(); ++k) {
    folders.insert(folders.begin() + static_cast<std::ptrdiff_t>(4 * k + 1), innocents[k]);
  }
  const bool had_x = fs::exists("/tmp/x");
  const Outcome together = grading.grade(rubric, folders, "together", "--jobs 2");
  EXPECT_EQ(fs::exists("/tmp/x"), had_x);
  for (const Attack& attack : kAttacks) {
    const json result = grading.result(attack.name, "together");
    EXPECT_EQ(result["score"], attack.score) << attack.name;
    EXPECT_EQ(result["points"], kPoints) << attack.name;
    const std::string report = grading.file(attack.name, "report.html", "together");
    expect_parts(report, {attack.what});
    const char* const total = !result["refused"].is_null() ? ">could not be judged<"
                              : attack.score > 0           ? ">10 of 29<"
                                                           : ">0 of 29<";
    expect_parts(report, {total});
  }
  EXPECT_FALSE(fs::exists(grading.path("together/x")));
  grading.grade(rubric, innocents, "alone", "--jobs 1");
  for (const std::string& folder : innocents) {
    const std::string name = fs::path(folder).filename();
    const std::string alone = grading.file(name, "result.json", "alone");
    EXPECT_GT(alone.size(), 1000u) << name;
    EXPECT_EQ(without_times(grading.file(name, "result.json", "together")), without_times(alone))
        << name;
  }
}

TEST_F(Attacks, cover_every_attack_of_the_hostile_submission) {
  std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/submissions/hostile.cpp");
  const std::size_t from = text.find("#define ATTACKS") + 15;
  text = text.substr(from, text.find("enum class", from) - from);
  for (const Attack& attack : kAttacks) expect_parts(text, {std::string(" ") + attack.name});
  EXPECT_EQ(std::count(text.begin(), text.end(), ',') + 1, std::ssize(kAttacks));
}

/// Lines that come before those of rays.py, and try to read, write and list files.
constexpr const char* kSpy = R"(import os
def can(how, path):
    try:
        return bool(os.listdir(path) if how == "list" else open(path, how))
    except OSError:
        return False
)";

TEST_F(Attacks, cannot_read_other_submissions_the_rubric_or_the_results) {
  const std::string rubric = grading.short_rubric("", kNearestRoot);
  const std::string scene =
      grading.write("lecture7/behind.toml",
                    contents(RAYCHECK_SOURCE_DIR "/examples/rubrics/lecture7/behind.toml"));
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
  // The points that it would lose.
  const double seen = score_of_spy("reads", "can('r', '/usr/bin/env') and can('w', '/dev/null')");
  if (seen < 0) GTEST_SKIP() << "no bubblewrap keeps submissions apart here";
  EXPECT_LT(seen, 10);
  for (const std::string& path :
       {other + "/rays.py", rubric, scene, grading.path("out/other/result.json"),
        grading.path("out/grades.csv")}) {
    ASSERT_FALSE(contents(path).empty()) << path;
  }
  const std::string result = grading.path("out/other/result.json");
  std::string condition = "can('list', '" + grading.path("submissions") + "')";
  for (const std::string& path : {other + "/rays.py", rubric, result})
    condition += " or can('r', '" + path + "')";
  for (const std::string& path : {result, grading.path("out/new.json")})
    condition += " or can('w', '" + path + "')";
  EXPECT_EQ(score_of_spy("spies", condition), 10);
}

/// A renderer that draws with the program beside it, and then turns all colours into one grey.
constexpr const char* kGrey = R"(import subprocess, sys
subprocess.run(['./first_sphere_wins', *sys.argv[1:]], check=True)
head, pixels = open(sys.argv[2]).read().split('\n255\n')
with open(sys.argv[2], 'w') as image:
    image.write(head + '\n255\n')
    for pixel in pixels.splitlines():
        image.write('0 0 0\n' if pixel == '0 0 0' else '102 102 102\n')
)";

TEST_F(Attacks, by_colours_that_identify_no_sphere_earn_no_points_for_spheres) {
  const std::string folder = grading.submit_built("grey", "rt.cpp", "first_sphere_wins");
  fs::rename(folder + "/first_sphere_wins.rt", folder + "/first_sphere_wins");
  grading.write("submissions/grey/grey.py", kGrey);
  const std::string whole = item_of("whole scenes", "points = 10",
                                    "[item.pictures]\nsources = [\"course\"]\ncases = 2\n");
  grading.grade(grading.short_rubric("", all_items() + whole), {folder});
  const json result = grading.result("grey");
  EXPECT_EQ(item(result, "pixel (0, 0)")["state"], "holds");
  for (const char* name : {"nearest sphere", "whole scenes"}) {
    EXPECT_EQ(item(result, name)["state"], "not asked") << name;
    EXPECT_EQ(item(result, name)["points"], 0) << name;
    EXPECT_EQ(item(result, name)["reason"]["kind"], "other colours");
  }
  EXPECT_EQ(result["points"], 14) << "neither right nor wrong";
}

TEST_F(Attacks, by_renderers_that_hang_take_at_most_the_time_of_the_rubric) {
  const std::string scenes = item_of("whole scenes", "points = 10",
                                     "[item.pictures]\nsources = [\"course\"]\ncases = 9\n");
  const std::string rubric =
      grading.short_rubric("reply_seconds = 1\nseconds = 3\n", kPixelZeroZero + scenes);
  // It draws the dry run's pictures.
  const std::string in_time =
      "if 'eye 0 0 40' not in open(sys.argv[1]).read():\n"
      "    import time; time.sleep(1000)\n";
  grading.grade(rubric,
                {grading.hand_in("hangs", "rt.py", renderer_in_python(in_time)),
                 grading.hand_in("never", "rt.cpp",
                                 "#include <unistd.h>\nint main() { for (;;) pause(); }\n")});
  const json hangs = grading.result("hangs");
  EXPECT_EQ(hangs["score"], 0);
  expect_parts(hangs.dump(), {"did not end, and used almost no CPU time for 1 s"});
  EXPECT_EQ(item(hangs, "whole scenes")["reason"], json({{"kind", "time is up"}, {"seconds", 3}}));
  const json never = grading.result("never");
  EXPECT_EQ(never["score"], 0);
  expect_parts(never["refused"]["why"],
               {"did not end, and used almost no CPU time for 1 s (reply_seconds)"});
}

TEST_F(Attacks, by_links_pipes_and_names_are_refused_and_other_submissions_graded) {
  const std::string right = grading.submit("right", "rays.py");
  fs::create_directory_symlink(right, grading.path("submissions/link"));
  const std::string pipe = grading.path("submissions/pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  grading.write("submissions/mark/rays.{file}", "");
  const std::string rubric = grading.write(
      "mark.toml", std::string("[[form]]\nhas = \"rays.{*\"\ncandidate = \"source:{file}\"\n") +
                       kFormOfPython + kNearestRoot);
  grading.grade(rubric,
                {grading.path("submissions/link"), pipe, grading.path("submissions/mark"), right});
  for (const char* name : {"link", "pipe"}) {
    EXPECT_EQ(grading.result(name)["refused"]["why"], "it is neither a file nor a folder");
  }
  EXPECT_FALSE(grading.result("mark")["refused"].is_null());
  EXPECT_EQ(grading.result("right")["score"], 10);
}

}  // namespace
}  // namespace raycheck::tests
