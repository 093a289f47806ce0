// Control groups of programs: processes cannot leave them, they enforce limits, they are removed,
// and if none can be made, the reason is reported.

#include "tools/external/sandbox/control_group.h"

#include <fcntl.h>
#include <sys/file.h>

#include <system_error>

#include "tests/tools/external/judged.h"
#include "tests/tools/external/machine.h"

namespace raycheck::tests {
namespace {

constexpr const char* kGroupScene = "scene/examples/probe.toml";
constexpr uid_t kNobodysUser = 65534;

std::vector<fs::path> groups_in(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory(gone)) folders.push_back(entry.path());
  }
  return folders;
}

/// A control group for raycheck, like those of `systemd-run --scope -p Delegate=yes`.
class Delegated {
 public:
  Delegated() {
    if (geteuid() != 0) {
      why_not_ = "only root can make a delegated group";
      return;
    }
    try {
      const fs::path own =
          tools::own_control_group(contents("/proc/self/mountinfo"), contents("/proc/self/cgroup"));
      for (const char* one : {"+memory", "+pids"}) {
        std::ofstream(own / "cgroup.subtree_control") << one;
      }
      const fs::path path = own / ("test-of-raycheck-" + std::to_string(getpid()));
      if (!fs::create_directory(path)) throw std::runtime_error(path.string() + " is there");
      path_ = path;
    } catch (const std::runtime_error& error) {
      why_not_ = error.what();
    }
  }
  ~Delegated() {
    if (path_.empty()) return;
    std::ofstream(path_ / "cgroup.kill") << 1;
    eventually([this] { return rmdir(path_.c_str()) == 0; });
  }
  Delegated(const Delegated&) = delete;
  Delegated& operator=(const Delegated&) = delete;

  /// Why there is none on this machine; empty if there is one.
  const std::string& why_not() const { return why_not_; }
  const fs::path& path() const { return path_; }
  void give_to(uid_t user) const {
    for (const char* file : {"", "cgroup.procs", "cgroup.threads", "cgroup.subtree_control"}) {
      EXPECT_EQ(chown((path_ / file).c_str(), user, user), 0) << file;
    }
  }
  /// The controllers of its subgroups.
  std::string controllers() const { return contents(path_ / "cgroup.subtree_control"); }
  /// A killed run leaves controllers enabled, and then no process may enter.
  void switch_off_controllers() const {
    for (const char* one : {"-memory", "-pids", "-cpu"}) {
      std::ofstream(path_ / "cgroup.subtree_control") << one;
    }
  }
  bool offers(const std::string& controller) const {
    return contents(path_ / "cgroup.controllers").find(controller) != std::string::npos;
  }

  /// The report of `raycheck check` in the group, run by these words, after these lines of shell.
  json judged(const std::string& words, const std::string& candidate, const std::string& more = "",
              const std::string& before = "") const {
    const Outcome outcome =
        run_bash(before + "echo $$ > '" + path_.string() + "/cgroup.procs' && exec " + words +
                 "'" RAYCHECK_BINARY "' check " + kGroupScene + " --format json " + more +
                 " --candidate '" + candidate + "'\n");
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.err << outcome.out;
    if (outcome.out.empty()) return {};
    return json::parse(outcome.out)["candidates"][0];
  }

 private:
  std::string why_not_;
  fs::path path_;
};

std::string group_isolation(const json& candidate) {
  return candidate.value("isolated_by", std::string("nothing"));
}

/// Tests on several machines; machines that cannot be simulated here are skipped.
class HostileControlGroupOn : public testing::TestWithParam<Machine> {
 protected:
  void SetUp() override {
    if (!delegated.why_not().empty()) GTEST_SKIP() << delegated.why_not();
    const std::string test = GetParam().words() + "test -x '" RAYCHECK_BINARY "'";
    if (std::system(test.c_str()) != 0) GTEST_SKIP() << "does not work here: " << test;
    if (!GetParam().is_root) delegated.give_to(kNobodysUser);
  }
  const Delegated delegated;
};

INSTANTIATE_TEST_SUITE_P(Machines, HostileControlGroupOn, testing::ValuesIn(kMachines),
                         kNameOfMachine);

TEST_P(HostileControlGroupOn, CannotBeLeftOrChangedByItsProcesses) {
  // The program tries the given path, the path of its group, and every path that it finds.
  const std::string lines = R"(
own = open('/proc/self/cgroup').read().split('0::')[1].strip()
given = sys.argv[1]
mounted = given.rsplit('/', 1)[0]
folders = {given, mounted, mounted + own, given + own}
for place in '/sys/fs/cgroup', given:
    folders.update(folder for folder, _, _ in os.walk(place))
gained = []
for folder in sorted(folders):
    for name in ('cgroup.procs', 'cgroup.threads', 'cgroup.kill', 'cgroup.subtree_control',
                 'cgroup.max.descendants', 'memory.max', 'pids.max'):
        try:
            os.close(os.open(folder + '/' + name, os.O_WRONLY))
            gained.append(folder + '/' + name)
        except OSError:
            pass
    try:
        os.mkdir(folder + '/mine')
        gained.append(folder + '/mine')
    except OSError:
        pass
here = os.getcwd().encode()
if ctypes.CDLL(None).mount(b'none', here, b'cgroup2', 0, None) == 0:
    gained.append('a mount')
sys.exit('gained ' + ' '.join(gained) if gained else 'tried %d' % len(folders)))";
  const json candidate =
      delegated.judged(GetParam().words(), python_renderer(lines, delegated.path().string()));
  if (!GetParam().has_bubblewrap &&
      group_isolation(candidate).find("Landlock") == std::string::npos && !GetParam().is_root) {
    EXPECT_EQ(group_isolation(candidate).find("control group"), std::string::npos);
    GTEST_SKIP() << "this kernel has no Landlock: " << group_isolation(candidate);
  }
  expect_parts(group_isolation(candidate), {"control group"});
  const std::string words = candidate["worst"].dump();
  EXPECT_EQ(words.find("gained"), std::string::npos) << words;
  expect_parts(words, {"it printed: tried "});
  EXPECT_TRUE(groups_in(delegated.path()).empty()) << groups_in(delegated.path())[0];
  EXPECT_TRUE(delegated.controllers().empty()) << delegated.controllers();
}

TEST_P(HostileControlGroupOn, LimitsTheTotalOfProcesses) {
  if (!delegated.offers("pids"))
    GTEST_SKIP() << "the kernel does not count processes in such groups";
  // The kernel also counts the user's other processes, of which there are some here.
  const std::string others = std::string("for k in $(seq 40); do ") + kAsNobody +
                             "sleep 100 & others=\"$others $!\"; done\n" +
                             "(sleep 30; kill $others) & sleep 0.5\n";
  const json candidate = delegated.judged(GetParam().words(), python_renderer(R"(
count = 1
try:
    while count < 200:
        if os.fork() == 0:
            time.sleep(60)
        count += 1
except OSError:
    pass
sys.exit('count: %d.' % count))"),
                                          "", others);
  expect_parts(group_isolation(candidate), {"processes)"});
  const std::string words = candidate["worst"].dump();
  const std::size_t at = words.find("count: ");
  ASSERT_NE(at, std::string::npos) << words;
  const int count = std::atoi(words.c_str() + at + std::string("count: ").size());
  EXPECT_LE(count, 64);
  EXPECT_GE(count, 60);
}

TEST_P(HostileControlGroupOn, LimitsTheTotalMemory) {
  if (!delegated.offers("memory"))
    GTEST_SKIP() << "the kernel does not count memory in such groups";
  const json candidate = delegated.judged(GetParam().words(), python_renderer(R"(
for k in range(5):
    if os.fork() == 0:
        kept = b'x' * (1000 << 20)
        time.sleep(60)
time.sleep(60))"),
                                          "--timeout 30");
  expect_parts(group_isolation(candidate), {"(memory"});
  expect_parts(candidate["worst"].dump(), {"was stopped: it uses more than 4096 MiB of memory"});
}

TEST(HostileControlGroup, IsNotMadeBesideOtherProcessesAndTheReasonIsGiven) {
  const Delegated delegated;
  if (!delegated.why_not().empty()) GTEST_SKIP() << delegated.why_not();
  const std::string submission = temporary_file("notes.txt", "nothing that runs\n");
  const std::string out = temporary_folder("out") + "/out";
  const std::string group = delegated.path().string();
  /// The isolation that raycheck reports in the group, after these lines of shell.
  const auto said = [&](const std::string& before) {
    const Outcome outcome =
        run_bash("echo $$ > '" + group + "/cgroup.procs'\n" + before +
                 "'" RAYCHECK_BINARY "' grade examples/rubrics/lecture7.toml '" + submission +
                 "' --sandbox available --out '" + out + "'\n");
    fs::remove_all(out);
    return behind("isolated by: ", outcome.out + "isolated by: nothing: " + outcome.err);
  };
  const std::string alone = said("exec ");
  expect_parts(alone, {", control group"});
  const std::string mounted = "'" + fs::path(group).parent_path().string() + "'";
  const std::string closed =
      said("exec unshare -m sh -c \"mount --bind " + mounted + " " + mounted +
           " && mount -o remount,ro,bind " + mounted + " && exec \\\"\\$@\\\"\" sh ");
  expect_parts(closed, {"; no control group: " + group, ": Read-only file system"});
  EXPECT_TRUE(groups_in(delegated.path()).empty()) << groups_in(delegated.path())[0];
  const std::string beside = said("sleep 60 & ");
  expect_parts(beside, {"; no control group: " + group + " holds other processes besides"});
}

TEST(HostileControlGroup, HoldsOrphansAndIsRemovedByTheNextRun) {
  const Delegated delegated;
  if (!delegated.why_not().empty()) GTEST_SKIP() << delegated.why_not();
  const std::string mark = std::to_string(920000000 + getpid());
  const std::string candidate = python_renderer(
      "for k in range(4):\n  if os.fork() == 0:\n    os.setsid()\n    if os.fork() == 0:\n"
      "      os.execvp('sleep', ['sleep', '" +
      mark + "'])\n    os._exit(0)\ntime.sleep(60)\n");
  const pid_t child =
      start_shell("echo $$ > '" + delegated.path().string() +
                  "/cgroup.procs' && exec '" RAYCHECK_BINARY "' check " + kGroupScene +
                  " --timeout 60 --candidate '" + candidate + "' >/dev/null 2>&1");
  EXPECT_TRUE(eventually([&] { return processes_with(mark).size() == 4; }));
  const std::vector<pid_t> held = processes_with(mark);
  const std::string begin = "/raycheck-" + std::to_string(child) + "-";
  for (const pid_t one : held) {
    const std::string group = contents("/proc/" + std::to_string(one) + "/cgroup");
    expect_parts(group, {begin});
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(eventually([&] { return processes_with(mark).empty(); }));
  // There are raycheck's own group, and the groups of programs.
  EXPECT_GE(groups_in(delegated.path()).size(), 2u);
  delegated.switch_off_controllers();
  const json next = delegated.judged("", python_renderer("pass"));
  expect_parts(group_isolation(next), {"control group"});
  EXPECT_TRUE(groups_in(delegated.path()).empty()) << groups_in(delegated.path())[0];
}

TEST(HostileControlGroup, OfAnInvisibleRunIsKeptWhileItIsLocked) {
  const Delegated delegated;
  if (!delegated.why_not().empty()) GTEST_SKIP() << delegated.why_not();
  // As after a run in another PID namespace, no process here has this id.
  const fs::path group = delegated.path() / "raycheck-99999999-0";
  fs::create_directory(group);
  const int held = open(group.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(flock(held, LOCK_SH), 0);
  delegated.judged("", python_renderer("pass"));
  EXPECT_TRUE(fs::exists(group));
  close(held);
  delegated.judged("", python_renderer("pass"));
  EXPECT_FALSE(fs::exists(group));
}

/// A machine's /proc/self/mountinfo and /proc/self/cgroup, and the path of raycheck's group, or why
/// there is none.
struct MountedGroups {
  const char* name;
  const char *mountinfo, *cgroup;
  const char *path, *why;
};

constexpr const char* kNoGroups = "this machine has no control groups of version 2";

constexpr MountedGroups kMountedGroups[] = {
    {"unified",
     "24 30 0:22 / /proc rw,nosuid - proc proc rw\n"
     "29 23 0:25 / /sys/fs/cgroup rw,nosuid,nodev,noexec,relatime shared:9 - cgroup2 cgroup2 "
     "rw,nsdelegate,memory_recursiveprot\n",
     "0::/user.slice/user-1000.slice/user@1000.service/app.slice/run-r1.scope\n",
     "/sys/fs/cgroup/user.slice/user-1000.slice/user@1000.service/app.slice/run-r1.scope",
     "no error"},
    {"hybrid",
     "31 23 0:28 / /sys/fs/cgroup rw - tmpfs tmpfs rw,mode=755\n"
     "35 31 0:32 / /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory\n"
     "41 31 0:38 / /sys/fs/cgroup/unified rw,relatime - cgroup2 cgroup2 rw\n",
     "4:memory:/some/group\n1:name=systemd:/\n0::/\n", "/sys/fs/cgroup/unified", "no error"},
    // The folder exists. Only trying shows whether it can be written.
    {"container_that_may_read",
     "609 608 0:26 / /sys/fs/cgroup ro,nosuid,nodev,noexec,relatime - cgroup2 cgroup rw\n",
     "0::/\n", "/sys/fs/cgroup", "no error"},
    {"container_that_sees_its_own_alone",
     "609 608 0:26 /docker/3f1 /sys/fs/cgroup rw,relatime - cgroup2 cgroup rw\n",
     "0::/docker/3f1/inner\n", "/sys/fs/cgroup/inner", "no error"},
    {"second_of_two_mounts",
     "50 30 0:26 /docker/3f /elsewhere rw - cgroup2 cgroup rw\n"
     "51 30 0:26 /docker/3f1 /a\\040b\\134c rw - cgroup2 cgroup rw\n",
     "0::/docker/3f1\n", "/a b\\c", "no error"},
    {"mounted_for_others", "50 30 0:26 /docker/3f /elsewhere rw - cgroup2 cgroup rw\n",
     "0::/docker/3f1\n", "", "raycheck's own control group, /docker/3f1, is not mounted"},
    {"outside_of_its_namespace", "50 30 0:26 / /sys/fs/cgroup rw - cgroup2 cgroup rw\n",
     "0::/../other\n", "", "raycheck's own control group, /../other, is not mounted"},
    {"version_1_alone", "35 31 0:32 / /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory\n",
     "4:memory:/some/group\n", "", kNoGroups},
    {"not_mounted", "24 30 0:22 / /proc rw,nosuid - proc proc rw\n", "0::/\n", "", kNoGroups},
    {"without_proc", "", "", "", kNoGroups}};

TEST(HostileControlGroup, IsFoundWhereItIsMounted) {
  for (const MountedGroups& machine : kMountedGroups) {
    std::string path;
    const std::string why = thrown_by<std::runtime_error>(
        [&] { path = tools::own_control_group(machine.mountinfo, machine.cgroup); });
    EXPECT_EQ(path, machine.path) << machine.name;
    EXPECT_EQ(why, machine.why) << machine.name;
  }
}

TEST(HostileControlGroup, IsBlamedOnlyForItsOwnMemoryLimit) {
  EXPECT_TRUE(
      tools::has_met_memory_limit("low 0\nhigh 0\nmax 812\noom 1\noom_kill 4\noom_group_kill 1\n"));
  EXPECT_FALSE(tools::has_met_memory_limit("low 0\nhigh 0\nmax 812\noom 0\noom_kill 0\n"));
  // Killed because the machine, or a parent group, ran out of memory.
  EXPECT_FALSE(tools::has_met_memory_limit("low 0\nhigh 0\nmax 0\noom 0\noom_kill 2\n"));
  EXPECT_FALSE(tools::has_met_memory_limit(""));
}

}  // namespace
}  // namespace raycheck::tests
