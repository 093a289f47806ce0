// Limits on all processes of a candidate together, and the removal of these processes.

#include <sched.h>
#include <sys/syscall.h>

#include <atomic>
#include <ctime>

#include "tests/tools/external/judged.h"
#include "tests/tools/grade/grading.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tests {
namespace {

constexpr const char* kScene = "scene/examples/probe.toml";

/// The report on a candidate, with these options.
std::string words_of(const std::string& candidate, const std::string& more) {
  return judged(kScene, candidate, more)["worst"].dump();
}

/// The report on a program with low limits, in place of a renderer.
std::string words_of_small(const std::string& name, const std::string& lines,
                           const std::string& more) {
  const std::string rubric = temporary_file(
      name + ".toml",
      "[limits]\ndisk_mib = 24\nfile_mib = 8\nmemory_mib = 256\n" +
          (kFormOfPython + item_of("frames", "points = 1", functions("frame", "course", 1))));
  const std::string program =
      temporary_file(name + ".py", "import os, time\n" + lines + "\ntime.sleep(60)\n");
  const Outcome outcome = run("grade " + rubric + " " + program + " --probe --format json " + more);
  return outcome.out.empty() ? outcome.err
                             : json::parse(outcome.out)["submissions"][0]["refused"].dump();
}

class HostileProcess : public testing::TestWithParam<const char*> {};

TEST_P(HostileProcess, HasALimitOnDiskUse) {
  expect_parts(words_of_small("disk", "for k in range(8): open(str(k), 'wb').write(bytes(4 << 20))",
                              GetParam()),
               {"was stopped: its files take more than 24 MiB (disk_mib)"});
}

TEST_P(HostileProcess, HasALimitOnTotalMemory) {
  // Each process is within its limit.
  expect_parts(words_of_small("memory",
                              "for k in range(5):\n  if os.fork() == 0:\n"
                              "    kept = b'x' * (60 << 20)\n    time.sleep(60)",
                              GetParam()),
               {"was stopped: it uses more than 256 MiB of memory (memory_mib)"});
}

TEST_P(HostileProcess, LeavesNoProcessRunning) {
  const std::string mark = std::to_string(900000000 + getpid());
  const std::string orphans =
      "for k in range(8):\n  if os.fork() == 0:\n    os.setsid()\n    if os.fork() == 0:\n"
      "      os.execvp('sleep', ['sleep', '" +
      mark + "'])\n    os._exit(0)\ntime.sleep(0.2)\n";
  for (const char* end : {"", "sys.stdout.close()\ntime.sleep(60)", "os.kill(os.getpid(), 9)"}) {
    words_of(python_renderer(orphans + end), std::string("--timeout 1 ") + GetParam());
    EXPECT_EQ(processes_with(mark).size(), 0u) << end;
  }
}

TEST_P(HostileProcess, LeavesNoProcessRunningThatForksAndExits) {
  // Each process ends before it can be examined. Processes that are left after three seconds are
  // counted.
  const auto mark = [](int k) { return std::to_string(920000000 + 2 * getpid() + k); };
  const std::string ends[] = {"", "time.sleep(60)"};
  for (int k = 0; k < 2; ++k) {
    words_of(python_renderer("for k in range(4):\n  if os.fork() == 0:\n    os.setsid()\n"
                             "    end = time.time() + 3\n    while time.time() < end:\n"
                             "      if os.fork() != 0: os._exit(0)\n    os.execvp('sleep', ['" +
                             mark(k) + "', '9'])\ntime.sleep(0.2)\n" + ends[k]),
             std::string("--timeout 1 ") + GetParam());
  }
  std::this_thread::sleep_for(std::chrono::seconds(4));
  for (int k = 0; k < 2; ++k) EXPECT_EQ(processes_with(mark(k)).size(), 0u) << ends[k];
}

TEST_P(HostileProcess, IsStoppedInTimeDespiteEndlessOutput) {
  // There was a defect by which a limit of two seconds took sixty-eight.
  for (const char* stream : {"stderr", "stdout"}) {
    expect_parts(
        words_of(python_renderer(std::string("while True: sys.") + stream + ".write('x' * 65536)"),
                 std::string("--timeout 1 ") + GetParam()),
        {"did not end within 1"});
  }
}

TEST_P(HostileProcess, HasALimitOnFolderDepth) {
  expect_parts(words_of(python_renderer(
                            "for k in range(3000):\n  os.mkdir('d' * 200)\n  os.chdir('d' * 200)\n"
                            "time.sleep(60)"),
                        GetParam()),
               {"was stopped: its folders are nested too deep"});
}

TEST_P(HostileProcess, HasALimitOnDiskUseByRemovedFiles) {
  expect_parts(words_of_small("removed",
                              "kept = []\nfor k in range(8):\n  kept.append(open('x', 'wb', 0))\n"
                              "  os.unlink('x')\n  kept[-1].write(bytes(4 << 20))",
                              GetParam()),
               {"was stopped: its files take more than 24 MiB (disk_mib)"});
}

TEST_P(HostileProcess, HasALimitOnTheNumberOfFiles) {
  // With more files, a check takes long and delays the other checks.
  expect_parts(
      words_of(python_renderer("for k in range(" + std::to_string(tools::kMostFiles + 1000) +
                               "): os.close(os.open(str(k), os.O_CREAT))\n"
                               "time.sleep(60)"),
               std::string("--timeout 300 ") + GetParam()),
      {"was stopped: it has more than " + std::to_string(tools::kMostFiles) + " files"});
}

INSTANTIATE_TEST_SUITE_P(Sandbox, HostileProcess,
                         testing::Values("--sandbox available", "--sandbox none --i-know"),
                         [](const auto& the_test) {
                           return has(the_test.param, "none") ? "none" : "available";
                         });

TEST(HostileClock, IsNotStoppedByAParentInUninterruptibleSleep) {
  // The state is that of waiting for a disk, which was once taken for the machine's fault.
  expect_parts(
      words_of(python_renderer(
                   "import ctypes\nlibc = ctypes.PyDLL(None)\nif libc.vfork() == 0: libc.pause()"),
               "--timeout 1"),
      {"did not end"});
}

/// A right candidate, after these lines of Python.
std::string right_after(const std::string& lines) {
  return python_renderer(lines + "\nos.execvp('python3', ['python3', '" +
                         std::string(RAYCHECK_SOURCE_DIR) +
                         "/tests/candidates/rt.py', 'right'] + sys.argv[1:])");
}

TEST(HostileClock, CountsCpuTimeAndNotSleep) {
  // It takes more than its limit in total, in short pieces.
  const json report =
      judged(kScene,
             right_after("for k in range(5):\n  time.sleep(0.5)\n  began = time.process_time()\n"
                         "  while time.process_time() < began + 0.03: pass"),
             "--timeout 2 --sandbox none --i-know");
  EXPECT_EQ(report["discrepancies"], 0) << report["worst"].dump(2);
}

TEST(HostileClock, StopsMostlyIdleProgramsAfterAMultipleOfTheLimit) {
  expect_parts(
      words_of(python_renderer("while True:\n  time.sleep(0.1)\n  began = time.process_time()\n"
                               "  while time.process_time() < began + 0.004: pass"),
               "--timeout 0.3"),
      {"did not end within 3 s of waiting, and used less than 0.3 s of CPU time"});
}

TEST(HostileClock, IncludesTimeOfUnreapedChildren) {
  double before = 0, after = 0;
  tools::process_tree(getpid(), &before);
  const pid_t child = fork();
  if (child == 0) {
    while (std::clock() < CLOCKS_PER_SEC / 5) {
    }
    _exit(0);
  }
  siginfo_t ended{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);
  tools::process_tree(getpid(), &after);
  EXPECT_GT(after - before, 0.15);
  waitpid(child, nullptr, 0);
}

TEST(HostileRoom, CannotBeReservedBeyondTheSizeOfAFile) {
  // KEEP_SIZE and INSERT_RANGE, and the ioctl() forms of the first: RESVSP, RESVSP64, ZERO_RANGE.
  expect_parts(
      words_of(
          python_renderer(
              "import ctypes, fcntl, struct\nsaid = []\nlibc = ctypes.CDLL(None, use_errno=True)\n"
              "file = open('x', 'wb')\nfile.truncate(1 << 20)\n"
              "for mode, size in (1, 1 << 28), (32, 1 << 28), (0, 4096):\n"
              "  done = libc.fallocate(file.fileno(), mode, ctypes.c_long(0), "
              "ctypes.c_long(size))\n"
              "  said.append(ctypes.get_errno() if done else 'done')\n"
              "room = struct.pack('hhqqii4i', 0, 0, 0, 1 << 28, 0, 0, 0, 0, 0, 0)\n"
              "for number in 40, 42, 57:\n  try:\n"
              "    fcntl.ioctl(file, 0x40305800 | number, room)\n    said.append('done')\n"
              "  except OSError as error: said.append(error.errno)\n"
              "sys.exit('%d kept, ' % os.fstat(file.fileno()).st_blocks + str(said))"),
          ""),
      {"8 kept, [95, 95, 'done', 95, 95, 95]"});
}

/// Keeps the processor busy to which it restricts this process.
class Thieves {
 public:
  explicit Thieves(int count) {
    sched_getaffinity(0, sizeof all_, &all_);
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof one, &one);
    for (int k = 0; k < count; ++k) {
      const pid_t pid = fork();
      if (pid == 0) {
        for (std::atomic<int> n = 0;;) ++n;
      }
      pids_.push_back(pid);
    }
  }
  ~Thieves() {
    for (const pid_t pid : pids_) kill(pid, SIGKILL);
    for (const pid_t pid : pids_) waitpid(pid, nullptr, 0);
    sched_setaffinity(0, sizeof all_, &all_);
  }

 private:
  cpu_set_t all_;
  std::vector<pid_t> pids_;
};

TEST(HostileNeighbours, DoNotUseUpACandidatesTime) {
  const Thieves thieves(2);
  // It takes half of its time, without neighbours.
  const json report = judged(kScene,
                             right_after("began = time.process_time()\n"
                                         "while time.process_time() < began + 1: pass"),
                             "--timeout 2 --sandbox none --i-know");
  EXPECT_EQ(report["discrepancies"], 0) << report["worst"].dump(2);
}

TEST(HostileTree, IncludesAProcessWhoseFirstThreadHasEnded) {
  const pid_t child = fork();
  if (child == 0) {
    std::thread([] { pause(); }).detach();
    syscall(SYS_exit, 0);
  }
  const std::string stat = "/proc/" + std::to_string(child) + "/stat";
  EXPECT_TRUE(eventually([&] { return has(contents(stat), ") Z "); })) << contents(stat);
  const std::vector<tools::ProcessState> tree = tools::process_tree(getpid());
  EXPECT_TRUE(
      std::any_of(tree.begin(), tree.end(), [&](const auto& one) { return one.pid == child; }));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

TEST(HostileSupervisor, IsEndedEvenIfStopped) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGTERM, [](int) { _exit(3); });
    for (;;) raise(SIGSTOP);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, WUNTRACED), child);
  EXPECT_TRUE(tools::end_supervised(child));
  EXPECT_NE(kill(child, 0), 0);
}

TEST(HostileEnds, OfRaycheckItselfAreCleanedUpByTheNextRun) {
  const fs::path folder = temporary_folder("left");
  const std::string mark = std::to_string(910000000 + getpid());
  const std::string candidate = python_renderer("subprocess.run(['sleep', '" + mark + "'])");
  const std::string other = python_renderer("pass");
  const auto folders = [&] {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
    return all;
  };
  const pid_t child =
      start_shell("export TMPDIR='" + folder.string() + "' && exec '" RAYCHECK_BINARY "' check " +
                  kScene + " --timeout 60 --candidate '" + candidate + "' >/dev/null 2>&1");
  ASSERT_TRUE(eventually([&] { return !processes_with(mark).empty(); }));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(eventually([&] { return processes_with(mark).empty(); }));
  ASSERT_EQ(folders().size(), 1u);
  const Variable temporary("TMPDIR", folder);
  EXPECT_GT(judged(kScene, other)["discrepancies"], 0);
  EXPECT_TRUE(folders().empty()) << folders()[0];
}

TEST(HostileEnds, OfRunsKeepFoldersOfOthersWithSimilarNames) {
  const fs::path folder = temporary_folder("named");
  const fs::path own = folder / "raycheck-run-week03";
  fs::create_directories(own);
  std::ofstream(own / "notes.txt") << "do not lose";
  const Variable temporary("TMPDIR", folder);
  EXPECT_GT(judged(kScene, python_renderer("pass"))["discrepancies"], 0);
  EXPECT_EQ(contents(own / "notes.txt"), "do not lose");
}

}  // namespace
}  // namespace raycheck::tests
