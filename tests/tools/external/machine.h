#pragma once

#include <ostream>

#include "tests/standard.h"

namespace raycheck::tests {

/// Prefixes that run a command as a user that owns nothing, and without bubblewrap.
inline constexpr const char* kAsNobody = "setpriv --reuid 65534 --regid 65534 --clear-groups ";
inline constexpr const char* kWithoutBubblewrap =
    "unshare -m sh -c 'mount --bind /dev/null /usr/bin/bwrap && exec \"$@\"' sh ";

/// A machine with these means of isolation.
struct Machine {
  const char* name;
  bool is_root, has_bubblewrap;
  std::string words() const {
    return std::string(has_bubblewrap ? "" : kWithoutBubblewrap) + (is_root ? "" : kAsNobody);
  }
  /// Its isolation; a control group may be added.
  std::string isolation() const {
    return std::string(is_root ? "own user, " : "") + "seccomp, " +
           (has_bubblewrap ? "bubblewrap" : "Landlock");
  }
};
inline void PrintTo(const Machine& machine, std::ostream* out) { *out << machine.name; }

inline constexpr std::array<Machine, 4> kMachines = {
    {{"root", true, true},
     {"root_without_bubblewrap", true, false},
     {"unprivileged", false, true},
     {"unprivileged_without_bubblewrap", false, false}}};

inline const auto kNameOfMachine = [](const auto& the_test) {
  return std::string(the_test.param.name);
};

}  // namespace raycheck::tests
