#pragma once

#include <filesystem>
#include <string>

#include "tools/external/sandbox/descriptor.h"
#include "tools/external/sandbox/launch.h"

namespace raycheck::tools {

/// The folder of a process's own control group (version 2), from the texts of its
/// /proc/self/mountinfo and /proc/self/cgroup: cgroups(7), proc(5).
/// Errors: std::runtime_error that says why there is none.
std::filesystem::path own_control_group(const std::string& mountinfo, const std::string& cgroup);

/// What the kernel limits in this run's groups. In each it measures time and kills all at once.
struct GroupLimits {
  bool memory = false, processes = false;
};

/// Prepares raycheck's own group to hold the groups of this run, moves raycheck out of it if the
/// kernel requires that, and removes what dead runs left there.
/// Errors: std::runtime_error that says why not; then nothing has changed.
GroupLimits begin_control_groups();
/// Undoes begin_control_groups(), as does the end of raycheck.
void end_control_groups();

/// Whether something was killed because the group met its own memory limit, by the text of its
/// memory.events; not if the machine, or a parent group, ran out of memory.
bool has_met_memory_limit(const std::string& events);

/// The control group of a program and all that it starts, with their limits together: it ends
/// with the object, and kills them. Domain: the groups have begun.
class ControlGroup {
 public:
  /// Errors: std::system_error if it cannot be made with all limits that `layers` names.
  ControlGroup(const Layers& layers, const Limits& limits);
  ~ControlGroup();
  ControlGroup(const ControlGroup&) = delete;
  ControlGroup& operator=(const ControlGroup&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// The CPU time of everything that ever ran in it.
  double cpu_seconds() const;
  /// Whether it has met its memory limit, by its memory.events.
  bool has_met_memory_limit() const;
  /// Kills all processes in it. False if the kernel cannot (before 5.14).
  bool kill() const;

 private:
  std::filesystem::path path_;
  Descriptor folder_;  ///< Locked, so that no other run takes it for a dead run's.
};

}  // namespace raycheck::tools
