// What is kept between runs: nothing is built or asked twice, and nothing else is believed.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Without a sandbox, so that builds and programs may say, in files of the test, that they were
/// started.
constexpr const char* kUnkept = "--sandbox none --i-know --format json ";

/// A library of functions that is right about spheres; what it does when it starts comes first.
constexpr const char* kHits = R"(
import raycheck_candidate as rc
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def intersect(ray, sphere, asked):
    P, D = ray
    n = dot(D, D) ** 0.5
    D = [x / n for x in D]
    Q, r = sphere
    T = [q - p for q, p in zip(Q, P)]
    v = dot(T, D)
    d2 = r * r - dot(T, T) + v * v
    if d2 < 0: return None
    s = v - d2 ** 0.5
    if s < 0: s = v + d2 ** 0.5
    if s < 0: return None
    return s / n, tuple(p + s * x for p, x in zip(P, D))
rc.run('hits', intersect=intersect)
)";

class Store : public testing::Test {
 protected:
  /// A rubric of one item that programs `rays.py` are asked, and renderers `rt.py`.
  std::string rubric(int points, const std::string& more = "") const {
    return grading.write("rubric.toml", "reply_seconds = 2\n" + more + R"(
[driver]
preset = "B"
[[form]]
has = "rays.py"
build = "echo x >> ')" + grading.path("builds") +
                                            R"('"
candidate = "command:python3 {file}"
[[form]]
has = "rt.py"
candidate = "renderer:python3 {file} {scene} {image}"
[[item]]
name = "hits"
points = )" + std::to_string(points) + R"(
[item.functions]
laws = ["class"]
rays = "given"
sources = ["rays"]
cases = 5
[item.pictures]
judge = "mask"
sources = ["course"]
cases = 1
)");
  }

  /// A submission that says that it is started.
  std::string submit(const std::string& name, const std::string& file, const std::string& text) {
    const std::string start = "open('" + grading.path("starts") + "', 'a').write('x\\n')\n";
    grading.write("submissions/" + name + "/" + file, start + text);
    return grading.path("submissions/" + name);
  }

  std::size_t lines(const std::string& file) const {
    const std::string text = contents(grading.path(file));
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  json graded(const std::string& by, const std::vector<std::string>& folders,
              const std::string& out = "out") const {
    return json::parse(grading.grade(by, folders, out, kUnkept).out);
  }

  /// What a grade says, times aside.
  static json said(json result) {
    for (const char* key : {"build_seconds", "judge_seconds", "build_is_stored"}) {
      result.erase(key);
    }
    return result;
  }

  fs::path stored(const std::string& what) const {
    return fs::path(grading.path("out/.raycheck")) / what;
  }

  Grading grading;
};

TEST_F(Store, starts_and_builds_nothing_when_an_item_has_changed) {
  const std::vector<std::string> folders = {submit("functions", "rays.py", kHits),
                                            submit("pictures", "rt.py", white_renderer())};
  const json first = graded(rubric(10), folders);
  EXPECT_EQ(first["submissions"][0]["score"], 10) << first.dump(2);
  EXPECT_EQ(first["submissions"][1]["score"], 0);
  const std::size_t starts = lines("starts"), builds = lines("builds");
  EXPECT_GT(starts, 4u);
  EXPECT_EQ(builds, 1u);
  const json again = graded(rubric(12), folders);
  EXPECT_TRUE(again["submissions"][0]["build_is_stored"]);
  EXPECT_FALSE(first["submissions"][0]["build_is_stored"]);
  EXPECT_EQ(lines("starts"), starts);
  EXPECT_EQ(lines("builds"), builds);
  const json anew = graded(rubric(12), folders, "other");
  EXPECT_GT(lines("starts"), starts);
  for (std::size_t k = 0; k < folders.size(); ++k) {
    EXPECT_EQ(said(again["submissions"][k]), said(anew["submissions"][k]));
  }
  EXPECT_EQ(again["submissions"][0]["score"], 12);
}

TEST_F(Store, gives_the_same_reason_for_a_program_that_makes_no_picture) {
  // It exits with 3 in the first form, and comes farther in the others.
  const std::string program = submit("mine", "rt.py", "FIRST = '" + grading.path("first") + R"('
import os, sys
text = open(sys.argv[1]).read()
if not os.path.exists(FIRST): open(FIRST, 'w').write(text)
print('one line')
print('another')
sys.exit(3 if text == open(FIRST).read() else 0)
)");
  const auto of_any_form = [&](int points) {
    std::string text = contents(rubric(points));
    text.insert(text.find("[[form]]"), "others = true\n");
    return grading.write("any.toml", text);
  };
  const json first = graded(of_any_form(10), {program})["submissions"][0];
  EXPECT_EQ(first["refused"]["why"], "it made no picture {image}") << first.dump(2);
  EXPECT_EQ(first["refused"]["said"], "one line\nanother");
  const std::size_t starts = lines("starts");
  EXPECT_EQ(graded(of_any_form(12), {program})["submissions"][0]["refused"], first["refused"]);
  EXPECT_EQ(lines("starts"), starts);
}

TEST_F(Store, builds_equal_submissions_once_and_asks_what_has_changed_or_was_not_asked) {
  const std::string folder = submit("mine", "rays.py", kHits);
  const json report = graded(
      rubric(10), {folder, submit("two", "rays.py", kHits), submit("three", "rays.py", kHits)});
  EXPECT_EQ(lines("builds"), 1u);
  for (const json& one : report["submissions"]) EXPECT_EQ(one["score"], 10);
  const std::size_t starts = lines("starts");
  submit("mine", "rays.py", std::string(kHits) + "# changed\n");
  graded(rubric(10), {folder});
  EXPECT_EQ(lines("builds"), 2u);
  EXPECT_GT(lines("starts"), starts);
  const std::size_t then = lines("starts");
  graded(rubric(10, "[conventions]\nroot = \"smaller\"\n"), {folder});
  EXPECT_EQ(lines("builds"), 2u);
  EXPECT_GT(lines("starts"), then) << "other requests";
}

TEST_F(Store, refuses_what_is_not_as_it_was_kept) {
  const std::string folder = submit("mine", "rays.py", kHits);
  graded(rubric(10), {folder});
  const std::size_t starts = lines("starts");
  const auto change = [](const fs::path& path, const std::string& from, const std::string& to) {
    std::string text = contents(path.string());
    const std::size_t at = from.empty() ? text.size() - 1 : text.find(from);
    ASSERT_NE(at, std::string::npos) << path;
    text.replace(at, std::max<std::size_t>(1, from.size()), to);
    std::ofstream(path, std::ios::binary) << text;
  };
  int changed = 0;
  for (const auto& entry : fs::directory_iterator(stored("answers"))) {
    change(entry.path(), "", "?");
    ++changed;
  }
  EXPECT_EQ(changed, 1);
  EXPECT_EQ(graded(rubric(11), {folder})["submissions"][0]["score"], 11);
  EXPECT_GT(lines("starts"), starts);
  EXPECT_EQ(lines("builds"), 1u);
  for (const auto& entry : fs::directory_iterator(stored("builds"))) {
    change(entry.path() / "files/rays.py", "return None", "return 1, (0, 0, 0)");
  }
  EXPECT_EQ(graded(rubric(12), {folder})["submissions"][0]["score"], 12);
  EXPECT_EQ(lines("builds"), 2u);
}

TEST_F(Store, keeps_no_failure_that_time_may_mend) {
  const std::string there = grading.path("there");
  const std::string folder =
      submit("slow", "rays.py",
             "import os, time\nif not os.path.exists('" + there + "'): time.sleep(60)\n" + kHits);
  const json slow = graded(rubric(10), {folder});
  EXPECT_FALSE(slow["submissions"][0]["refused"].is_null()) << slow.dump(2);
  grading.write("there", "");
  EXPECT_EQ(graded(rubric(11), {folder})["submissions"][0]["score"], 11);
}

TEST_F(Store, keeps_that_replies_took_too_long) {
  std::string hangs = kHits;
  hangs.insert(hangs.find("    P, D = ray"), "    import time; time.sleep(60)\n");
  const std::string folder = submit("hangs", "rays.py", hangs);
  const json first = graded(rubric(10), {folder});
  const std::size_t starts = lines("starts");
  const std::string said = "gave no reply, and computed next to nothing for 2 s";
  expect_parts(first.dump(), {said});
  expect_parts(graded(rubric(11), {folder}).dump(), {said});
  EXPECT_EQ(lines("starts"), starts);
}

/// The shards of a class: whoever is graded is not graded again, and the class is what one run
/// makes.
TEST_F(Store, grades_a_class_in_shards_into_one_folder) {
  std::vector<std::string> folders;
  for (const char* name : {"ada", "ben", "cleo"}) folders.push_back(submit(name, "rays.py", kHits));
  const json whole = graded(rubric(10), folders, "whole");
  const std::string asked = "--sandbox none --i-know --shard ";
  EXPECT_EQ(grading.grade(rubric(10), folders, "out", asked + "2/2").out, "");
  EXPECT_TRUE(fs::exists(grading.path("out/ben/result.json")));
  EXPECT_FALSE(fs::exists(grading.path("out/ada/result.json")));
  expect_refused("merge " + grading.path("out"),
                 grading.path("out") + ": unit 1 of 3 is missing, and 1 more");
  grading.grade(rubric(10), folders, "out", asked + "1/2");
  EXPECT_FALSE(fs::exists(grading.path("out/index.html")));
  const std::size_t starts = lines("starts");
  grading.grade(rubric(10), folders, "out", asked + "1/1");
  const json merged = printed_json("merge --sandbox none --i-know " + grading.path("out"), 0);
  EXPECT_EQ(lines("starts"), starts);
  ASSERT_EQ(merged["submissions"].size(), folders.size());
  for (std::size_t k = 0; k < folders.size(); ++k) {
    EXPECT_EQ(said(merged["submissions"][k]), said(whole["submissions"][k]));
  }
  EXPECT_TRUE(fs::exists(grading.path("out/index.html")));
}

TEST_F(Store, is_its_owners_and_no_submission_is_called_so) {
  const std::string folder = submit("mine", "rays.py", kHits);
  graded(rubric(10), {folder});
  struct stat status {};
  ASSERT_EQ(stat(stored("").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0700u);
  const std::string hidden = submit(".raycheck", "rays.py", kHits);
  expect_refused(grading.arguments(rubric(10), {hidden}, "out", kUnkept), "rename it");
}

}  // namespace
}  // namespace raycheck::tests
