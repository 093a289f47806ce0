#pragma once

#include <filesystem>
#include <string>

#include "tools/external/sandbox/descriptor.h"
#include "tools/external/sandbox/launch.h"

namespace raycheck::tools {

/// The folder of a process's own control group (version 2), from the texts of its
/// /proc/self/mountinfo and /proc/self/cgroup (see cgroups(7), proc(5)).
/// Errors: std::runtime_error with the reason if there is none.
std::filesystem::path own_control_group(const std::string& mountinfo, const std::string& cgroup);

/// The limits that the kernel can enforce in this run's groups. In each group, the kernel also
/// measures CPU time and can kill all processes at once.
struct GroupLimits {
  bool memory = false, processes = false;
};

/// Prepares raycheck's own group to contain the groups of this run: moves raycheck out of it if the
/// kernel requires that, and removes groups left by dead runs.
/// Errors: std::runtime_error with the reason; then nothing has changed.
GroupLimits begin_control_groups();
/// Undoes begin_control_groups(); called when raycheck ends, too.
void end_control_groups();

/// Whether a process was killed because the group met its own memory limit, from the text of the
/// group's memory.events. False if the machine, or a parent group, ran out of memory.
bool has_met_memory_limit(const std::string& events);

/// The control group of a program and all its descendants, with limits on their total. The
/// destructor kills them and removes the group. Domain: after begin_control_groups().
class ControlGroup {
 public:
  /// Errors: std::system_error if the group cannot be made with all limits that `layers` names.
  ControlGroup(const Layers& layers, const Limits& limits);
  ~ControlGroup();
  ControlGroup(const ControlGroup&) = delete;
  ControlGroup& operator=(const ControlGroup&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// The CPU time of all processes that ever ran in it.
  double cpu_seconds() const;
  /// Whether it has met its memory limit.
  bool has_met_memory_limit() const;
  /// Kills all processes in it. False if the kernel cannot (before 5.14).
  bool kill() const;

 private:
  std::filesystem::path path_;
  Descriptor folder_;  ///< Locked, so that other runs do not remove the group.
};

}  // namespace raycheck::tools
