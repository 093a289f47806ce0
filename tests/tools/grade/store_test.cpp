// The store of builds and answers: later runs build and ask nothing twice, and ignore changed
// files.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// Builds and programs may record their starts in files of the test.
const std::string kUnkept = std::string(kLimitsOnly) + "--format json ";

/// The lines of a right `intersect`; commands to run at the start come before it.
const std::string kHits =
    replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.py"),
             "frame=frame, pixel_point=pixel_point, pixel_ray=pixel_ray,\n"
             "           focal_ray=focal_ray, intersect=intersect, nearest=nearest",
             "intersect=intersect");

/// A right `intersect` that begins with a command.
std::string hits_but_first(const std::string& line) {
  const std::string start = "    (origin, d), (centre, r) =";
  return replaced(kHits, start, "    " + line + "\n" + start);
}

class Store : public testing::Test {
 protected:
  /// A rubric of one item for programs `rays.py` and renderers `rt.py`.
  std::string rubric(int points, const std::string& more = "") const {
    return grading.write("rubric.toml", "reply_seconds = 1\n" + more + R"(
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
)" +
                                            item_of("hits", "points = " + std::to_string(points),
                                                    functions("class", "rays", 5, kGivenRays) +
                                                        pictures("full.toml")));
  }

  /// A submission that records its starts.
  std::string submit(const std::string& name, const std::string& file, const std::string& text) {
    const std::string starts = "'" + grading.path("starts") + "'";
    return grading.hand_in(name, file, "open(" + starts + ", 'a').write('x\\n')\n" + text);
  }

  std::size_t lines(const std::string& file) const {
    const std::string text = contents(grading.path(file));
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  json graded(const std::string& by, const std::vector<std::string>& folders,
              const std::string& out = "out") const {
    return json::parse(grading.grade(by, folders, out, kUnkept).out);
  }

  /// A grade without times.
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

TEST_F(Store, reuses_builds_and_answers_after_a_change_of_an_item) {
  const std::vector<std::string> folders = {
      submit("functions", "rays.py", kHits), submit("pictures", "rt.py", renderer_in_python()),
      submit("wrong", "rt.py",
             renderer_in_python("right = shown\n"
                                "def shown(k): return [0, 0, 0] if k % 2 else right(k)\n"))};
  const json first = graded(rubric(10), folders);
  for (const std::size_t right : {0, 1}) {
    EXPECT_EQ(first["submissions"][right]["score"], 10) << first.dump(2);
  }
  EXPECT_EQ(first["submissions"][2]["score"], 0);
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
  for (const std::size_t right : {0, 1}) EXPECT_EQ(again["submissions"][right]["score"], 12);
}

TEST_F(Store, gives_the_same_reason_again_for_a_program_without_a_picture) {
  // The program exits with 3 in the first form, and gets farther in the others.
  const std::string program = submit("mine", "rt.py", "first = '" + grading.path("first") + R"py('
import os, sys
asked = open(sys.argv[1]).read()
if not os.path.exists(first): open(first, 'w').write(asked)
print('one line\nanother')
sys.exit(3 if asked == open(first).read() else 0)
)py");
  const auto of_any_form = [&](int points) {
    std::string text = contents(rubric(points));
    text.insert(text.find("[[form]]"), "others = true\n");
    return grading.write("any.toml", text);
  };
  const json first = graded(of_any_form(10), {program})["submissions"][0];
  EXPECT_EQ(first["refused"]["why"], "it exited with 0, but did not write its picture, image.ppm")
      << first.dump(2);
  EXPECT_EQ(first["refused"]["said"], "one line\nanother");
  const std::size_t starts = lines("starts");
  EXPECT_EQ(graded(of_any_form(12), {program})["submissions"][0]["refused"], first["refused"]);
  EXPECT_EQ(lines("starts"), starts);
}

/// Its folder has another name in each run.
TEST_F(Store, gives_a_reason_without_the_folder_of_the_run_that_heard_it) {
  const std::string program =
      submit("mine", "rt.py",
             "import sys\nprint(__file__, file=sys.stderr)\nprint('b', file=sys.stderr)\n");
  const json first = graded(rubric(10), {program})["submissions"][0]["refused"];
  EXPECT_EQ(first["said"], "rt.py\nb");
  EXPECT_EQ(graded(rubric(12), {program})["submissions"][0]["refused"], first);
}

TEST_F(Store, builds_equal_submissions_once_and_asks_only_new_or_changed_questions) {
  const std::string folder = submit("mine", "rays.py", kHits);
  const json report = graded(
      rubric(10), {folder, submit("two", "rays.py", kHits), submit("three", "rays.py", kHits)});
  EXPECT_EQ(lines("builds"), 1u);
  for (const json& one : report["submissions"]) EXPECT_EQ(one["score"], 10);
  const auto asked_again = [&](const std::string& keys, const std::string& more = "") {
    const std::size_t before = lines("starts");
    const auto by = rubric(10, keys);
    const json now = json::parse(grading.grade(by, {folder}, "out", kUnkept + more).out);
    EXPECT_GT(lines("starts"), before) << keys << more;
    EXPECT_EQ(lines("builds"), 2u);
    return now["submissions"][0];
  };
  submit("mine", "rays.py", hits_but_first("return None"));
  EXPECT_EQ(asked_again("")["score"], 0) << "another text";
  asked_again("[conventions]\nroot = \"smaller\"\n");
  EXPECT_EQ(asked_again("", "--seed 2")["seed"], 2);
}

TEST_F(Store, ignores_stored_files_that_were_changed) {
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

TEST_F(Store, does_not_store_failures_that_may_be_temporary) {
  const std::string there = grading.path("there");
  const std::string folder =
      submit("slow", "rays.py",
             "import os, time\nif not os.path.exists('" + there + "'): time.sleep(60)\n" + kHits);
  const json slow = graded(rubric(10), {folder});
  EXPECT_FALSE(slow["submissions"][0]["refused"].is_null()) << slow.dump(2);
  grading.write("there", "");
  EXPECT_EQ(graded(rubric(11), {folder})["submissions"][0]["score"], 11);
}

TEST_F(Store, stores_time_outs_of_replies) {
  const std::string folder =
      submit("hangs", "rays.py", hits_but_first("import time; time.sleep(60)"));
  const json first = graded(rubric(10), {folder});
  const std::size_t starts = lines("starts");
  const std::string said = "gave no reply, and used almost no CPU time for 1 s";
  expect_parts(first.dump(), {said});
  expect_parts(graded(rubric(11), {folder}).dump(), {said});
  EXPECT_EQ(lines("starts"), starts);
}

/// Grades the shards of a class: a graded submission is not graded again, and the result equals
/// that of one run.
TEST_F(Store, grades_a_class_in_shards_into_one_folder) {
  std::vector<std::string> folders;
  for (const char* name : {"ada", "ben", "cleo"}) folders.push_back(submit(name, "rays.py", kHits));
  const json whole = graded(rubric(10), folders, "whole");
  const std::string asked = std::string(kLimitsOnly) + "--shard ";
  EXPECT_EQ(grading.grade(rubric(10), folders, "out", asked + "2/2").out, "");
  EXPECT_TRUE(fs::exists(grading.path("out/ben/result.json")));
  EXPECT_FALSE(fs::exists(grading.path("out/ada/result.json")));
  expect_refused("merge " + grading.path("out"), "--run-candidates");
  expect_refused("merge --run-candidates " + grading.path("out"),
                 grading.path("out") + ": unit 1 of 3 is missing, and 1 more");
  grading.grade(rubric(10), folders, "out", asked + "1/2");
  EXPECT_FALSE(fs::exists(grading.path("out/index.html")));
  const std::size_t starts = lines("starts");
  grading.grade(rubric(10), folders, "out", asked + "1/1");
  const json merged =
      printed_json("merge --run-candidates " + (kLimitsOnly + grading.path("out")), 0);
  EXPECT_EQ(lines("starts"), starts);
  ASSERT_EQ(merged["submissions"].size(), folders.size());
  for (std::size_t k = 0; k < folders.size(); ++k) {
    EXPECT_EQ(said(merged["submissions"][k]), said(whole["submissions"][k]));
  }
  EXPECT_TRUE(fs::exists(grading.path("out/index.html")));
}

TEST_F(Store, is_accessible_to_its_owner_only_and_its_name_is_reserved) {
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
