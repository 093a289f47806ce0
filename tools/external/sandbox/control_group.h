#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "tools/external/sandbox/launch.h"

namespace raycheck::tools {

/// The folder of a process's own control group (version 2), of the texts of its
/// /proc/self/mountinfo and /proc/self/cgroup: cgroups(7), proc(5).
/// Errors: std::runtime_error with why there is none.
std::filesystem::path own_control_group(const std::string& mountinfo, const std::string& cgroup);

/// What the kernel limits in the groups of this run. In each it counts time and kills all at once.
struct GroupLimits {
  bool memory = false, processes = false;
};

/// Makes a place for the groups of this run below raycheck's own, from which it moves where the
/// kernel wants that, and removes what dead runs left there.
/// Errors: std::runtime_error with why there is none; then all is as it was.
GroupLimits begin_control_groups();
/// Undoes begin_control_groups(), as does the end of raycheck.
void end_control_groups();

/// Whether something was killed since the group met its own limit on memory, by the text of its
/// memory.events; not where the machine had too little, or a group above.
bool has_met_memory_limit(const std::string& events);

/// The control group of a program and all that it starts, with their limits together: it ends
/// with the object, and kills them. Domain: the groups have begun.
class ControlGroup {
 public:
  /// Errors: std::system_error where it cannot be made with all limits that `layers` names.
  ControlGroup(const Layers& layers, const Limits& limits);
  ~ControlGroup();
  ControlGroup(const ControlGroup&) = delete;
  ControlGroup& operator=(const ControlGroup&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// The CPU time of everything that ever ran in it.
  double cpu_seconds() const;
  /// Whether has_met_memory_limit() of its memory.events.
  bool has_met_memory_limit() const;
  /// Kills all in it. False where the kernel cannot (before 5.14).
  bool kill() const;

 private:
  std::filesystem::path path_;
  int folder_ = -1;  ///< Held, so that no other run takes it for a dead one's.
};

}  // namespace raycheck::tools
