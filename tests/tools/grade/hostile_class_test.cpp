// In a class with harmful submissions, the others get the same grades as without them.

#include <sys/mount.h>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// Mounts a disk of this size; empty if that is not possible.
class SmallDisk {
 public:
  SmallDisk(const std::string& path, const std::string& size) {
    fs::create_directories(path);
    if (mount("tmpfs", path.c_str(), "tmpfs", 0, ("size=" + size + ",mode=1777").c_str()) == 0) {
      path_ = path;
    }
  }
  ~SmallDisk() {
    if (!path_.empty()) umount2(path_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

constexpr const char* kFillsTheDisk = R"(
import os, time
for k in range(14):
    open('f%d' % k, 'wb').write(bytes(4 << 20))
time.sleep(60)
)";

class HostileClass : public GradingTest {};

TEST_F(HostileClass, keeps_its_grades_if_one_submission_fills_the_disk) {
  const SmallDisk disk(grading.path("disk"), "300m");
  if (disk.path().empty()) GTEST_SKIP() << "no disk can be mounted here";
  const std::string rubric = grading.short_rubric("reply_seconds = 20\n", kNearestRoot);
  const std::string fills = grading.hand_in("fills", "rays.py", kFillsTheDisk);
  const std::vector<std::string> innocents = {grading.submit_built("one", "rays.cpp", "none"),
                                              grading.submit("two", "rays.py"),
                                              grading.submit_built("three", "rt.cpp", "none")};
  std::vector<std::string> all = innocents;
  all.insert(all.begin(), fills);
  const Outcome alone = grading.grade(rubric, innocents, "alone");
  const Variable temporary("TMPDIR", disk.path());
  const Outcome together = grading.grade(rubric, all, "together", "--jobs 2", 4);
  expect_parts(together.out,
               {"less than 256 MiB of disk left",
                "1 of them for reasons outside the submission: run the same command"});
  EXPECT_FALSE(grading.result("fills", "together")["finished"]);
  for (const char* name : {"one", "two", "three"}) {
    EXPECT_EQ(without_times(grading.file(name, "result.json", "together")),
              without_times(grading.file(name, "result.json", "alone")));
  }
  // On a larger disk, it meets its own limit.
  const Outcome again = grading.grade(
      grading.short_rubric("reply_seconds = 20\nlimits = { disk_mib = 40 }\n", kNearestRoot),
      {fills}, "more");
  EXPECT_TRUE(has(again.out, "its files take more than 40 MiB (disk_mib)")) << again.out;
}

TEST_F(HostileClass, reports_in_table_and_spreadsheet_that_one_submission_used_up_its_time) {
  const std::string rubric = grading.short_rubric(
      "seconds = 2\nreply_seconds = 60\n",
      item_of("hit or miss", "points = 15", functions("class", "course", 9, kGivenRays)) +
          kNearestRoot + kNearestSphere);
  const std::vector<std::string> both = {grading.submit_built("slow", "hostile.cpp", "slow"),
                                         grading.submit_built("none", "hostile.cpp", "none")};
  const Outcome outcome = grading.grade(rubric, both);
  const json slow = grading.result("slow");
  for (const char* name : {"hit or miss", "nearest root"}) {
    const json cut = item(slow, name);
    EXPECT_EQ(cut["state"], "not judged") << cut.dump(2);
    EXPECT_EQ(cut["reason"], json({{"kind", "time is up"}, {"seconds", 2}}));
  }
  expect_values(slow, {{"score", 0}, {"points", 40}, {"finished", true}});
  EXPECT_TRUE(has(grading.file("slow", "report.html"),
                  "not judged: time is up: the limit for all questions together is 2 s"));
  std::string items;
  for (const json& item : slow["items"]) {
    if (!item["reason"].is_object() || item["reason"]["kind"] != "time is up") continue;
    items += (items.empty() ? "" : ", ") + item["name"].get<std::string>();
  }
  ASSERT_FALSE(items.empty()) << slow.dump(2);
  const std::string said = "time is up after 2 s: " + items + " not judged";
  EXPECT_TRUE(has(outcome.out, said)) << outcome.out;
  EXPECT_TRUE(has(grading.file("", "grades.csv"), said)) << grading.file("", "grades.csv");
}

TEST_F(HostileClass, judges_a_submission_again_that_was_killed_from_outside) {
  const std::string mark = "killed_" + std::to_string(getpid());
  const std::string victim =
      grading.submit("victim", "rays.py", "import time; time.sleep(2) # " + mark);
  fs::rename(victim + "/rays.py", victim + "/" + mark + "_rays.py");
  const std::string suicide =
      grading.hand_in("suicide", "rays.py", "import os\nos.kill(os.getpid(), 9)\n");
  const std::string rubric = grading.write("any.toml", kFormOfPython + kNearestRoot);
  std::thread killer([&] {
    eventually([&] {
      for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string line = contents(entry.path() / "cmdline");
        if (line.rfind("python3", 0) != 0 || !has(line, mark)) continue;
        kill(std::stoi(entry.path().filename()), SIGKILL);
        return true;
      }
      return false;
    });
  });
  const Outcome outcome = grading.grade(rubric, {victim, suicide}, "out", "--jobs 2");
  killer.join();
  const json killed = grading.result("victim");
  EXPECT_EQ(killed["score"], 10) << outcome.out;
  EXPECT_TRUE(killed["finished"]);
  // A program that kills itself does so again without other submissions; then it is graded.
  const json itself = grading.result("suicide");
  expect_values(itself, {{"score", 0}, {"finished", true}});
  EXPECT_TRUE(has(itself.dump(), "was killed by signal 9")) << itself.dump(2);
}

constexpr std::size_t kMany = 200000;

TEST(HostileIntake, survives_deep_nesting_and_many_spaces) {
  const Grading grading;
  const std::string spaces = repeated(" ", kMany);
  const std::pair<const char*, std::string> files[] = {
      {"a.ipynb", R"({"cells":[{"cell_type":"code","source":)" + repeated("[", kMany) +
                      repeated("]", kMany) + "}]}"},
      {"package.json",
       R"({"bin":)" + repeated(R"({"a":)", kMany) + "1" + repeated("}", kMany) + "}"},
      {"A.java", "public" + spaces + "static" + spaces + "void" + spaces + "x\nclass" + spaces +
                     "{ \n package" + spaces},
      {"a.cpp", "int" + spaces + "main" + spaces + "(\n#include" + spaces + "<x\n"}};
  std::vector<std::string> folders;
  for (const auto& [name, text] : files) {
    const std::string folder = std::string("submission of ") + name;
    grading.write(folder + "/" + name, text);
    folders.push_back(grading.path(folder));
  }
  // They are reported as invalid submissions.
  const Outcome outcome =
      grading.grade("lecture7.toml", folders, "out", "--probe --sandbox available", 1);
  expect_parts(outcome.out, {"4 submissions tried, 4 could not be judged"});
}

}  // namespace
}  // namespace raycheck::tests
