// What a candidate's processes may take together, and what is left of them.

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/tools/external/judged.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kScene = "scene/examples/probe.toml";

/// A renderer of these lines of Python, which comes after the imports.
std::string renderer(const std::string& name, const std::string& lines) {
  const std::string path =
      temporary_file(name + ".py", "import os, signal, subprocess, sys, time\n" + lines + "\n");
  return "renderer:python3 " + path + " {scene} {image}";
}

/// What is said of it, with these more options.
std::string words_of(const std::string& candidate, const std::string& more) {
  return judged(kScene, candidate, more)["worst"].dump();
}

bool says(const std::string& words, const std::string& part) {
  return words.find(part) != std::string::npos;
}

/// The number of processes whose command line has this text.
int processes_with(const std::string& text) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string line = contents(entry.path() / "cmdline");
    count += line.find(text) != std::string::npos ? 1 : 0;
  }
  return count;
}

class HostileProcess : public testing::TestWithParam<const char*> {};

TEST_P(HostileProcess, MayHaveSoMuchOnDiskInAll) {
  const std::string words =
      words_of(renderer("disk",
                        "for k in range(40):\n  open(str(k), 'wb').write(bytes(60 << 20))\n"
                        "time.sleep(60)"),
               GetParam());
  EXPECT_TRUE(says(words, "was stopped: its files take more than 1024 MiB")) << words;
}

TEST_P(HostileProcess, MayHaveSoMuchMemoryInAll) {
  // Each within what one may have.
  const std::string words =
      words_of(renderer("memory",
                        "for k in range(5):\n  if os.fork() == 0:\n"
                        "    kept = b'x' * (1000 << 20)\n    time.sleep(60)\ntime.sleep(60)"),
               std::string("--timeout 30 ") + GetParam());
  EXPECT_TRUE(says(words, "was stopped: it uses more than 4096 MiB of memory")) << words;
}

TEST_P(HostileProcess, LeavesNothingBehindThatRuns) {
  const std::string mark = std::to_string(900000000 + getpid());
  const std::string orphans =
      "for k in range(8):\n  if os.fork() == 0:\n    os.setsid()\n    if os.fork() == 0:\n"
      "      os.execvp('sleep', ['sleep', '" +
      mark + "'])\n    os._exit(0)\ntime.sleep(0.2)\n";
  for (const char* end : {"", "sys.stdout.close()\ntime.sleep(60)", "os.kill(os.getpid(), 9)"}) {
    words_of(renderer("orphans", orphans + end), std::string("--timeout 1 ") + GetParam());
    EXPECT_EQ(processes_with(mark), 0) << end;
  }
}

TEST_P(HostileProcess, LeavesNothingBehindThatStartsAnotherAndEnds) {
  // Whoever is looked at has ended. What is left after three seconds waits to be counted.
  const std::string mark = std::to_string(920000000 + getpid());
  const std::string hops =
      "for k in range(4):\n  if os.fork() == 0:\n    os.setsid()\n    end = time.time() + 3\n"
      "    while time.time() < end:\n      if os.fork() != 0: os._exit(0)\n"
      "    os.execvp('sleep', ['" +
      mark + "', '9'])\ntime.sleep(0.2)\n";
  for (const char* end : {"", "time.sleep(60)"}) {
    words_of(renderer("hops", hops + end), std::string("--timeout 1 ") + GetParam());
    std::this_thread::sleep_for(std::chrono::seconds(4));
    EXPECT_EQ(processes_with(mark), 0) << end;
  }
}

TEST_P(HostileProcess, IsNotHeardForLongerThanItsTime) {
  const auto begin = std::chrono::steady_clock::now();
  for (const char* stream : {"stderr", "stdout"}) {
    const std::string words = words_of(
        renderer("flood", std::string("while True: sys.") + stream + ".write('x' * 65536)"),
        std::string("--timeout 1 ") + GetParam());
    EXPECT_TRUE(says(words, "did not end within 1 s")) << words;
  }
  // Three pictures each. Sixty-eight seconds were once the end of two.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(40));
}

TEST_P(HostileProcess, NestsFoldersOnlySoDeep) {
  const std::string words =
      words_of(renderer("deep",
                        "for k in range(3000):\n  os.mkdir('d' * 200)\n  os.chdir('d' * 200)\n"
                        "time.sleep(60)"),
               GetParam());
  EXPECT_TRUE(says(words, "was stopped: it nests folders too deep")) << words;
}

TEST_P(HostileProcess, MayHaveSoMuchOnDiskInAllThatItRemoves) {
  const std::string words =
      words_of(renderer("removed",
                        "kept = []\nfor k in range(20):\n  kept.append(open('x', 'wb', 0))\n"
                        "  os.unlink('x')\n  kept[-1].write(bytes(60 << 20))\ntime.sleep(60)"),
               std::string("--timeout 30 ") + GetParam());
  EXPECT_TRUE(says(words, "was stopped: its files take more than 1024 MiB")) << words;
}

TEST_P(HostileProcess, HasOnlySoManyFiles) {
  // More take long to look at, and nothing else would be looked at.
  const std::string words =
      words_of(renderer("many", "for k in range(" + std::to_string(tools::kMostFiles + 1000) +
                                    "): os.close(os.open(str(k), os.O_CREAT))\n"
                                    "time.sleep(60)"),
               std::string("--timeout 300 ") + GetParam());
  EXPECT_TRUE(
      says(words, "was stopped: it has more than " + std::to_string(tools::kMostFiles) + " files"))
      << words;
}

INSTANTIATE_TEST_SUITE_P(Sandbox, HostileProcess, testing::Values("", "--sandbox none --i-know"),
                         [](const auto& the_test) {
                           return *the_test.param == '\0' ? "available" : "none";
                         });

TEST(HostileClock, IsNotStoppedByAParentThatSleepsDeeply) {
  // As one does that waits for a disk. Once it took two minutes, and was the machine's fault.
  const auto begin = std::chrono::steady_clock::now();
  const std::string words = words_of(
      renderer("deeply",
               "import ctypes\nlibc = ctypes.PyDLL(None)\nif libc.vfork() == 0: libc.pause()"),
      "--timeout 1");
  EXPECT_TRUE(says(words, "did not end within 1 s")) << words;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

TEST(HostileRoom, IsNotReservedBeyondTheSizeOfAFile) {
  // KEEP_SIZE and INSERT_RANGE, and what ioctl() calls the first: RESVSP, RESVSP64, ZERO_RANGE.
  const std::string words = words_of(
      renderer(
          "room",
          "import ctypes, fcntl, struct\nsaid = []\nlibc = ctypes.CDLL(None, use_errno=True)\n"
          "file = open('x', 'wb')\nfile.truncate(1 << 20)\n"
          "for mode, size in (1, 1 << 28), (32, 1 << 28), (0, 4096):\n"
          "  done = libc.fallocate(file.fileno(), mode, ctypes.c_long(0), ctypes.c_long(size))\n"
          "  said.append(ctypes.get_errno() if done else 'done')\n"
          "room = struct.pack('hhqqii4i', 0, 0, 0, 1 << 28, 0, 0, 0, 0, 0, 0)\n"
          "for number in 40, 42, 57:\n  try:\n"
          "    fcntl.ioctl(file, 0x40305800 | number, room)\n    said.append('done')\n"
          "  except OSError as error: said.append(error.errno)\n"
          "sys.exit('%d kept, ' % os.fstat(file.fileno()).st_blocks + str(said))"),
      "");
  EXPECT_TRUE(says(words, "8 kept, [95, 95, 'done', 95, 95, 95]")) << words;
}

/// Keeps every processor busy.
class Thieves {
 public:
  explicit Thieves(int count) {
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
  }

 private:
  std::vector<pid_t> pids_;
};

TEST(HostileNeighbours, TakeNoneOfACandidatesTime) {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  const Thieves thieves(4 * processors);
  // Half of its time, if it were alone.
  const json report = judged(kScene,
                             renderer("slow",
                                      "began = time.process_time()\n"
                                      "while time.process_time() < began + 1: pass\n"
                                      "os.execvp('python3', ['python3', '" +
                                          std::string(RAYCHECK_SOURCE_DIR) +
                                          "/tests/candidates/rt.py', 'right'] + sys.argv[1:])"),
                             "--timeout 2 --sandbox none --i-know");
  EXPECT_EQ(report["discrepancies"], 0) << report["worst"].dump(2);
}

TEST(HostileTree, HasAProcessWhoseFirstThreadHasEnded) {
  const pid_t child = fork();
  if (child == 0) {
    std::thread([] { sleep(60); }).detach();
    syscall(SYS_exit, 0);
  }
  const std::string stat = "/proc/" + std::to_string(child) + "/stat";
  for (int k = 0; k < 1000 && !says(contents(stat), ") Z "); ++k) usleep(10000);
  EXPECT_TRUE(says(contents(stat), ") Z "));
  const std::vector<tools::ProcessState> tree = tools::process_tree(getpid());
  EXPECT_TRUE(
      std::any_of(tree.begin(), tree.end(), [&](const auto& one) { return one.pid == child; }));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

TEST(HostileSupervisor, ThatIsStoppedIsEnded) {
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

TEST(HostileEnds, OfRaycheckItselfLeaveNothingThatTheNextRunDoesNotRemove) {
  const fs::path folder = temporary_file("left", "") + ".d";
  fs::create_directories(folder);
  fs::permissions(folder, fs::perms::others_exec, fs::perm_options::add);
  const std::string mark = std::to_string(910000000 + getpid());
  const std::string candidate = renderer("sleeps", "subprocess.run(['sleep', '" + mark + "'])");
  const std::string other = renderer("none", "pass");
  const auto folders = [&] {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
    return all;
  };
  const pid_t child = fork();
  if (child == 0) {
    setenv("TMPDIR", folder.c_str(), 1);
    const std::string command = std::string("cd '") + RAYCHECK_SOURCE_DIR + "' && exec '" +
                                RAYCHECK_BINARY + "' check " + kScene + " --timeout 60 " +
                                "--candidate '" + candidate + "' >/dev/null 2>&1";
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  for (int k = 0; k < 1000 && processes_with(mark) < 2; ++k) usleep(10000);
  ASSERT_GE(processes_with(mark), 1);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  for (int k = 0; k < 500 && processes_with(mark) > 0; ++k) usleep(10000);
  EXPECT_EQ(processes_with(mark), 0);
  ASSERT_EQ(folders().size(), 1u);
  // As if it had been a while ago.
  fs::last_write_time(folders()[0], fs::file_time_type::clock::now() - std::chrono::hours(1));
  const std::string before = std::getenv("TMPDIR") == nullptr ? "" : std::getenv("TMPDIR");
  setenv("TMPDIR", folder.c_str(), 1);
  EXPECT_GT(judged(kScene, other)["discrepancies"], 0);
  before.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", before.c_str(), 1);
  EXPECT_TRUE(folders().empty()) << folders()[0];
  fs::remove_all(folder);
}

TEST(HostileEnds, OfRunsRemoveNoFolderThatIsOnlyNamedAsTheirsAre) {
  const fs::path folder = temporary_file("named", "") + ".d";
  fs::create_directories(folder);
  fs::permissions(folder, fs::perms::others_exec, fs::perm_options::add);
  const fs::path own = folder / "raycheck-run-week03";
  fs::create_directories(own);
  std::ofstream(own / "notes.txt") << "do not lose";
  fs::last_write_time(own, fs::file_time_type::clock::now() - std::chrono::hours(1));
  const std::string before = std::getenv("TMPDIR") == nullptr ? "" : std::getenv("TMPDIR");
  setenv("TMPDIR", folder.c_str(), 1);
  EXPECT_GT(judged(kScene, renderer("none", "pass"))["discrepancies"], 0);
  before.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", before.c_str(), 1);
  EXPECT_EQ(contents(own / "notes.txt"), "do not lose");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace raycheck::tests
