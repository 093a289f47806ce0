#include "tools/external/sandbox/control_group.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace raycheck::tests {
namespace {

/// A machine's /proc/self/mountinfo and /proc/self/cgroup, and where raycheck's own group is then,
/// or why there is none.
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
     "/sys/fs/cgroup/user.slice/user-1000.slice/user@1000.service/app.slice/run-r1.scope", ""},
    {"hybrid",
     "31 23 0:28 / /sys/fs/cgroup rw - tmpfs tmpfs rw,mode=755\n"
     "35 31 0:32 / /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory\n"
     "41 31 0:38 / /sys/fs/cgroup/unified rw,relatime - cgroup2 cgroup2 rw\n",
     "4:memory:/some/group\n1:name=systemd:/\n0::/\n", "/sys/fs/cgroup/unified", ""},
    // The folder is there; that it cannot be written is known when it is tried.
    {"container_that_may_read",
     "609 608 0:26 / /sys/fs/cgroup ro,nosuid,nodev,noexec,relatime - cgroup2 cgroup rw\n",
     "0::/\n", "/sys/fs/cgroup", ""},
    {"container_that_sees_its_own_alone",
     "609 608 0:26 /docker/3f1 /sys/fs/cgroup rw,relatime - cgroup2 cgroup rw\n",
     "0::/docker/3f1/inner\n", "/sys/fs/cgroup/inner", ""},
    {"second_of_two_mounts",
     "50 30 0:26 /docker/3f /elsewhere rw - cgroup2 cgroup rw\n"
     "51 30 0:26 /docker/3f1 /a\\040b\\134c rw - cgroup2 cgroup rw\n",
     "0::/docker/3f1\n", "/a b\\c", ""},
    {"mounted_for_others", "50 30 0:26 /docker/3f /elsewhere rw - cgroup2 cgroup rw\n",
     "0::/docker/3f1\n", "", "raycheck's own control group, /docker/3f1, is mounted nowhere"},
    {"outside_of_its_namespace", "50 30 0:26 / /sys/fs/cgroup rw - cgroup2 cgroup rw\n",
     "0::/../other\n", "", "raycheck's own control group, /../other, is mounted nowhere"},
    {"version_1_alone", "35 31 0:32 / /sys/fs/cgroup/memory rw - cgroup cgroup rw,memory\n",
     "4:memory:/some/group\n", "", kNoGroups},
    {"not_mounted", "24 30 0:22 / /proc rw,nosuid - proc proc rw\n", "0::/\n", "", kNoGroups},
    {"without_proc", "", "", "", kNoGroups}};

TEST(HostileControlGroup, IsFoundWhereItIsMounted) {
  for (const MountedGroups& machine : kMountedGroups) {
    std::string path, why;
    try {
      path = tools::own_control_group(machine.mountinfo, machine.cgroup);
    } catch (const std::runtime_error& error) {
      why = error.what();
    }
    EXPECT_EQ(path, machine.path) << machine.name;
    EXPECT_EQ(why, machine.why) << machine.name;
  }
}

TEST(HostileControlGroup, IsToBlameForItsOwnMemoryAlone) {
  EXPECT_TRUE(
      tools::has_met_memory_limit("low 0\nhigh 0\nmax 812\noom 1\noom_kill 4\noom_group_kill 1\n"));
  EXPECT_FALSE(tools::has_met_memory_limit("low 0\nhigh 0\nmax 812\noom 0\noom_kill 0\n"));
  // By a machine that has no memory left, or for a group above.
  EXPECT_FALSE(tools::has_met_memory_limit("low 0\nhigh 0\nmax 0\noom 0\noom_kill 2\n"));
  EXPECT_FALSE(tools::has_met_memory_limit(""));
}

}  // namespace
}  // namespace raycheck::tests
