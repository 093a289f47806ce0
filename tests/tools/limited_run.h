#pragma once

#include "tests/tools/program.h"

namespace raycheck::tests {

/// How the program is run, and what comes in its way.
struct Circumstances {
  int signal = 0;
  double signal_after = 0;        ///< Seconds, once it catches signals.
  std::uint64_t memory = 0;       ///< Bytes of address space; 0: no limit.
  bool stalled = false;           ///< Nobody reads its output, which is lost.
  std::string stays_in = "/tmp";  ///< TMPDIR
};

struct LimitedOutcome {
  int exit_code = -1;  ///< Of one that a signal ends: minus the signal.
  std::string out, err;
  bool caught = false;         ///< It was seen to catch signals.
  bool was_signalled = false;  ///< It was still there when the signal was due.
  double seconds_after = 0;    ///< What it computed from the signal to the end.
};

/// Runs the built program, its standard input open and empty, in the source folder.
LimitedOutcome run_limited(const std::vector<std::string>& arguments, const Circumstances& how);

}  // namespace raycheck::tests
