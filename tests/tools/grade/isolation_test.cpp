// Isolation of submissions on machines with more and fewer layers: attacks earn no points, and
// missing layers are reported.

#include "tests/tools/external/machine.h"
#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// The points for right answers by the attacks' functions, and the points of all items.
constexpr double kRightHits = 10, kAll = 14;

std::string short_rubric(const Grading& grading, const std::string& keys = "") {
  return grading.short_rubric(keys, kPixelZeroZero + kNearestRoot);
}

/// Why a machine cannot be simulated here; empty if it can.
std::string why_not(const Machine& machine) {
  if (geteuid() != 0) return "only root can be another user or hide a program";
  if (std::system((machine.words() + "true").c_str()) != 0) return "no " + machine.words();
  if (std::system((machine.words() + "test -x '" RAYCHECK_BINARY "'").c_str()) != 0) {
    return std::string("closed to this user: ") + RAYCHECK_BINARY;
  }
  return "";
}

class HostileOnMachine : public testing::TestWithParam<Machine> {
 protected:
  void SetUp() override {
    const std::string why = why_not(GetParam());
    if (!why.empty()) GTEST_SKIP() << why;
    fs::create_directories(grading.path("out"));
    for (const char* folder : {"", "out"}) {
      ASSERT_EQ(chmod(grading.path(folder).c_str(), 0777), 0);
    }
  }

  /// Grades on the machine. `program`: the path of raycheck.
  Outcome grade(int exit_code, const std::string& rubric,
                const std::vector<std::string>& submissions, const std::string& more = "",
                const std::string& program = RAYCHECK_BINARY,
                const std::string& before = "") const {
    return run_bash(before + GetParam().words() + "'" + program + "' " +
                        grading.arguments(rubric, submissions, "out", "--jobs 2 " + more) + "\n",
                    exit_code);
  }
  /// The options with which `grade` works on the machine.
  std::string as_it_is() const { return GetParam().has_bubblewrap ? "" : "--sandbox available "; }

  const Grading grading;
};

INSTANTIATE_TEST_SUITE_P(Machines, HostileOnMachine, testing::ValuesIn(kMachines), kNameOfMachine);

TEST_P(HostileOnMachine, AttacksEarnNoPointsAndTheGraderSurvives) {
  if (GetParam().is_root && GetParam().has_bubblewrap) {
    GTEST_SKIP() << "Attacks.earn_no_points_and_do_not_change_other_grades tries this machine";
  }
  const std::string rubric = short_rubric(grading);
  const std::vector<std::string> attacks = {"none",          "kills_judge",   "weakens_judge",
                                            "reads_others",  "opens_socket",  "makes_namespaces",
                                            "leaves_memory", "runs_raycheck", "writes_outside"};
  std::vector<std::string> folders = grading.submit_each(attacks, "hostile.cpp");
  // Harmless submissions in other languages.
  folders.push_back(grading.submit("python", "rays.py"));
  const bool has_node = is_installed("node");
  if (has_node) folders.push_back(RAYCHECK_SOURCE_DIR "/tests/submissions/class/ella");
  const Outcome outcome = grade(0, rubric, folders, as_it_is());
  const std::string said = "isolated by: " + GetParam().isolation();
  if (!has(outcome.out, said)) GTEST_SKIP() << "this kernel has less: " << outcome.out;
  expect_parts(contents(grading.path("out/index.html")), {said});
  for (const std::string& attack : attacks) {
    const json result = grading.result(attack);
    EXPECT_EQ(result["score"], kRightHits) << attack;
    EXPECT_TRUE(result["finished"]) << attack;
    const std::string isolated_by = result["isolated_by"];
    EXPECT_TRUE(isolated_by.starts_with(GetParam().isolation())) << attack << isolated_by;
  }
  if (has_node) {
    EXPECT_EQ(grading.result("ella")["score"], kAll) << outcome.out;
  }
  EXPECT_EQ(grading.result("python")["score"], kAll) << outcome.out;
}

TEST_P(HostileOnMachine, RaycheckAndItsRubricsAreHiddenWhereTheyAreInstalled) {
  // raycheck is installed below /usr/local only for this test.
  const std::string build = fs::path(RAYCHECK_BINARY).parent_path().string();
  const std::string install = grading.write(
      "install.sh",
      "set -e\nmount -t tmpfs none /usr/local\nmkdir -p /usr/local/bin "
      "/usr/local/libexec/raycheck /usr/local/share/raycheck /usr/local/include\ncp '" +
          build + "'/raycheck /usr/local/bin/\ncp '" + build +
          "'/raycheck-* /usr/local/libexec/raycheck/\ncd '" + RAYCHECK_SOURCE_DIR +
          "'\ncp -r examples/rubrics tools/external/adapters/* "
          "/usr/local/share/raycheck/\ncp -r include/raycheck "
          "/usr/local/include/\nexec \"$@\"\n");
  const std::string before = "unshare -m sh '" + install + "' ";
  const std::string rubric = short_rubric(grading);
  const std::string attack = grading.submit_built("runs_raycheck", "hostile.cpp", "runs_raycheck");
  const std::string program = grading.submit("python", "rays.py");
  expect_parts(
      grade(0, rubric, {attack, program}, as_it_is(), "/usr/local/bin/raycheck", before).out,
      {"isolated by: " + GetParam().isolation()});
  EXPECT_EQ(grading.result("runs_raycheck")["score"], kRightHits);
  EXPECT_EQ(grading.result("python")["score"], kAll) << "the adapter is there";
}

TEST_P(HostileOnMachine, ConcurrentForkBombsDoNotRaiseTheirLimits) {
  const std::string rubric = grading.short_rubric("seconds = 2\nreply_seconds = 1\n", kNearestRoot);
  std::vector<std::string> submissions = {grading.submit("right", "rays.py")};
  for (const char* name : {"first", "second"}) {
    submissions.push_back(grading.hand_in(
        name, "rays.py", "import os\nwhile True:\n  try: os.fork()\n  except OSError: pass\n"));
  }
  const Outcome outcome = grade(0, rubric, submissions, as_it_is());
  EXPECT_EQ(grading.result("right")["score"], kRightHits);
  for (const char* name : {"first", "second"}) {
    EXPECT_EQ(grading.result(name)["score"], 0) << name;
    EXPECT_TRUE(grading.result(name)["finished"]) << name;
  }
}

TEST_P(HostileOnMachine, UnreadablePicturesAndFoldersAreNotFailuresOfTheMachine) {
  const std::string rubric = short_rubric(grading);
  const std::string picture =
      "#!/bin/sh\n{ echo P3 25 25 255; yes 255 255 255 | head -n 625; } > $2\nchmod 0 $2\n";
  const std::string file = grading.write("file/shell.rt", picture);
  const std::string folder = grading.write("folder/shell.rt", picture + "chmod 0 .\n");
  for (const std::string& program : {file, folder}) ASSERT_EQ(chmod(program.c_str(), 0755), 0);
  const Outcome outcome =
      grade(0, rubric, {fs::path(file).parent_path(), fs::path(folder).parent_path()}, as_it_is());
  for (const char* name : {"file", "folder"}) {
    EXPECT_TRUE(grading.result(name)["finished"]) << name << outcome.out;
    EXPECT_EQ(grading.result(name)["score"], 0) << name;
  }
}

TEST_P(HostileOnMachine, LessIsolationIsAnErrorUnlessRequested) {
  const std::string rubric = short_rubric(grading);
  const std::string right = grading.submit("right", "rays.py");
  const Outcome outcome = grade(GetParam().has_bubblewrap ? 0 : 2, rubric, {right});
  if (GetParam().has_bubblewrap) return;
  expect_parts(outcome.err,
               {"sandbox require: not available here: bubblewrap", "bwrap: Permission denied",
                "sandbox available, which uses only what works: ", GetParam().isolation()});
  EXPECT_FALSE(fs::exists(grading.path("out/right/result.json")));
  run_bash(
      GetParam().words() + "'" RAYCHECK_BINARY "' grade '" + rubric + "' '" + right + "' --probe\n",
      2);
}

TEST_P(HostileOnMachine, OtherProcessesOfTheUserDoNotCountAgainstSubmissions) {
  if (GetParam().is_root) GTEST_SKIP() << "as root each submission has a separate user";
  // The user has more than the 64 processes that a submission may have, as on a desktop.
  const std::string rubric = short_rubric(grading);
  const std::string threads = grading.submit("python", "rays.py");
  const std::string before = std::string("for k in $(seq 80); do ") + kAsNobody +
                             "sleep 100 & others=\"$others $!\"; done\ntrap 'kill $others' EXIT\n";
  expect_parts(grade(0, rubric, {threads}, as_it_is(), RAYCHECK_BINARY, before).out,
               {"isolated by: " + GetParam().isolation()});
  EXPECT_EQ(grading.result("python")["score"], kAll);
}

TEST(HostileJail, BlocksSignalsIfTheKernelCannot) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be another user";
  const Grading grading;
  // The jail program is copied, because the other user may not have access to the build folder.
  const std::string jail = grading.path("jail");
  fs::copy_file(fs::path(RAYCHECK_BINARY).parent_path() / "raycheck-jail", jail);
  // Only seccomp, without Landlock. The last line is reached only if the script is not killed.
  const std::string script = grading.write("signals.sh", R"(
sleep 100 &
judge=$!
')" + jail + R"(' seccomp=1 judge=$judge -- python3 -c "
import os, signal, sys
judge = int(sys.argv[1])
def refused(call):
    try:
        call()
    except OSError as error:
        return error.errno == 1
for target in judge, -1, -os.getpgid(judge), 1 << 32 | judge:
    try:
        assert refused(lambda: os.kill(target, signal.SIGKILL)), target
    except OverflowError:
        pass
assert refused(lambda: os.pidfd_open(judge))
assert refused(lambda: os.setpriority(os.PRIO_PROCESS, judge, 19))
assert refused(lambda: os.setpriority(os.PRIO_USER, 0, 19))
assert refused(lambda: os.sched_setaffinity(judge, [0]))
import resource
assert refused(lambda: resource.prlimit(judge, resource.RLIMIT_NOFILE, (0, 0)))
os.kill(os.getpid(), 0)
os.kill(0, 0)
os.nice(1)
resource.setrlimit(resource.RLIMIT_NOFILE, (16, 16))
print('kept', flush=True)
os.kill(os.getpid(), signal.SIGTERM)
" $judge
echo "ended with $?"
kill -0 $judge && echo 'the judge is alive'
kill $judge
)");
  const Outcome outcome = run_bash(kAsNobody + ("bash '" + script + "'\n"));
  EXPECT_EQ(outcome.out, "kept\nended with 143\nthe judge is alive\n") << outcome.err;
}

class HostileSandbox : public GradingTest {};

TEST_F(HostileSandbox, ThatFailsLaterIsNotSkipped) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can put a program in another's place";
  // The program works for the trial and for the candidate's introduction, and then fails.
  grading.write("count", "0\n");
  grading.write("bwrap",
                "#!/bin/sh\ncd '" + grading.path("") +
                    "'\ncase \"$*\" in */bin/true) exec ./real \"$@\" ;; esac\n"
                    "read -r n < count\necho $((n + 1)) > count\n[ $n -lt 1 ] && "
                    "exec ./real \"$@\"\necho 'bwrap: no room for namespaces' >&2\nexit 1\n");
  fs::copy_file("/usr/bin/bwrap", grading.path("real"));
  ASSERT_EQ(chmod(grading.path("bwrap").c_str(), 0755), 0);
  ASSERT_EQ(chmod(grading.path("count").c_str(), 0666), 0);
  const Outcome outcome =
      run_bash("exec unshare -m sh -c \"mount --bind '" + grading.path("bwrap") +
                   "' /usr/bin/bwrap && exec '" RAYCHECK_BINARY "' check '" RAYCHECK_SOURCE_DIR
                   "/scene/examples/lecture-examples.toml' --candidate "
                   "'command:python3 " RAYCHECK_SOURCE_DIR "/tests/candidates/right.py'\"\n",
               1);
  expect_parts(outcome.out, {"could not be started in its sandbox: bwrap: no room for "
                             "namespaces",
                             "bubblewrap"});
}

/// A TMPDIR, and the expected error; empty if it is usable.
struct TriedFolder {
  const char* name;
  mode_t mode;
  const char* said;
};

TEST(HostileTemporaryFolder, WorksOrIsRefusedBeforeGrading) {
  const Grading grading;
  const std::string rubric = short_rubric(grading);
  const std::string right = grading.submit("right", "rays.py");
  const TriedFolder folders[] = {
      {"plain-1.2_b+c", 0755, ""},
      {"a b", 0755, "its name contains ' '"},
      {"a[b", 0755, "its name contains '['"},
      {"a(b", 0755, "its name contains '('"},
      {"a:b", 0755, "its name contains ':'"},
      {"a\nb", 0755, "its name contains a control character"},
      {"closed", 0700, "candidates run as other users, who may not enter it"}};
  const auto grade_in = [&](const std::string& path) {
    return run_bash("export TMPDIR='" + path + "'\n'" RAYCHECK_BINARY "' " +
                    grading.arguments(rubric, {right}, "out") + "\n");
  };
  for (const auto& [name, mode, said] : folders) {
    if (mode == 0700 && geteuid() != 0) continue;
    const std::string path = grading.path(name);
    fs::create_directory(path);
    ASSERT_EQ(chmod(path.c_str(), mode), 0);
    const Outcome outcome = grade_in(path);
    EXPECT_EQ(outcome.exit_code, *said == 0 ? 0 : 2) << name << outcome.err;
    expect_parts(outcome.err, {said});
    EXPECT_EQ(fs::exists(grading.path("out/right/result.json")), *said == 0) << name;
    fs::remove_all(grading.path("out"));
  }
  expect_parts(grade_in("relative").err, {"it must begin with /"});
  expect_parts(grade_in(grading.path("nowhere")).err, {"there is no such folder"});
}

TEST(HostileTemporaryFolder, WithoutExecutionPreventsGrading) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can mount a folder where nothing runs";
  const Grading grading;
  const std::string rubric = short_rubric(grading);
  const std::string right = grading.submit("right", "rays.py");
  fs::create_directory(grading.path("noexec"));
  const std::string script =
      "exec unshare -m sh -c 'mount -t tmpfs -o noexec,mode=1777 none \"$TMPDIR\" && "
      "exec \"$@\"' sh '" RAYCHECK_BINARY "' " +
      grading.arguments(rubric, {right}, "out") + "\n";
  const Outcome outcome = run_bash(script);
  ASSERT_NE(outcome.exit_code, 0);
  const Variable temporary("TMPDIR", grading.path("noexec"));
  const Outcome there = run_bash(script, 2);
  // The error comes from the self-test, or from the jail program if that was copied to this folder
  // because others have no access to raycheck's.
  EXPECT_TRUE(has(there.err, "grading does not start: raycheck's own ") ||
              has(there.err, "/raycheck-jail cannot be started: Permission denied"))
      << there.err;
  EXPECT_FALSE(fs::exists(grading.path("out/right/result.json")));
}

TEST_F(HostileSandbox, WithoutTheJailProgramIsRefusedWithoutBlamingACandidate) {
  for (const char* program : {"raycheck", "raycheck-check", "raycheck-grade"}) {
    fs::copy_file(fs::path(RAYCHECK_BINARY).parent_path() / program, grading.path(program));
  }
  const std::string right = grading.submit("right", "rays.py");
  for (const std::string& command :
       {"grade " + short_rubric(grading) + " " + right + " --out " + grading.path("out"),
        "check " RAYCHECK_SOURCE_DIR "/scene/examples/optical-axis.toml --candidate source:" +
            right + "/rays.py"}) {
    const Outcome outcome =
        run_bash("exec '" + grading.path("raycheck") + "' " + command + "\n", 2);
    expect_parts(outcome.err, {"raycheck-jail: No such file or directory"});
    EXPECT_EQ(outcome.out, "");
  }
}

TEST_F(HostileSandbox, NoneRequiresIKnowForRoot) {
  const std::string rubric = short_rubric(grading);
  const std::string right = grading.submit("right", "rays.py");
  if (geteuid() == 0) {
    expect_refused(grading.arguments(rubric, {right}, "out", "--sandbox none"),
                   "--sandbox none: candidates would run as root");
    EXPECT_FALSE(fs::exists(grading.path("out")));
  }
  expect_parts(grading.grade(rubric, {right}, "out", "--sandbox none --i-know").out,
               {"isolated by: limits only"});
}

TEST(HostileSubmission, ThatBringsProgramsAndPicturesIsListedForTheInstructor) {
  const Grading grading;
  const std::string folder = grading.submit("brings", "rays.py");
  grading.write("submissions/brings/helper", std::string("\x7f") + "ELF and so on");
  grading.write("submissions/brings/table.py", "TABLE = '" + std::string(5000, 'x') + "'\n");
  grading.write("submissions/brings/stored.ppm", "P6 1 1 255\n   ");
  grading.write("submissions/brings/notes.txt", "nothing to say of it\n");
  grading.grade(short_rubric(grading), {folder});
  const json files = grading.result("brings")["opaque_files"];
  ASSERT_EQ(files.size(), 3u) << files;
  expect_values(files,
                {{"0", json({{"name", "helper"}, {"kind", "program or library"}, {"bytes", 14}})},
                 {"1/kind", "picture"},
                 {"2/kind", "text with very long lines"}});
  const std::string page = contents(grading.path("out/index.html"));
  expect_parts(page, {"helper (program or library, 1 KiB), stored.ppm (picture, 1 KiB)"});
  EXPECT_FALSE(has(grading.file("brings", "report.html"), "helper"))
      << "only instructors may see it";
}

}  // namespace
}  // namespace raycheck::tests
