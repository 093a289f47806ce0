#ifndef RAYCHECK_TOOLS_TERMINAL_H_
#define RAYCHECK_TOOLS_TERMINAL_H_

#include <chrono>
#include <string>
#include <string_view>

#include "properties/run_control.h"

namespace raycheck::tools {

/// Makes Ctrl-C (or SIGTERM) raise a flag instead of ending the program; a second one ends it. For
/// work that takes no RunControl.
void catch_interrupts();
bool interrupted();

/// Whether standard output takes colours: a terminal, and NO_COLOR is not set.
bool stdout_takes_colours();

/// One line on standard error that says how far long work has come; silent when standard error is
/// no terminal, and for the first second.
class Progress {
 public:
  explicit Progress(std::string what);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();
  void show(std::string_view state);

 private:
  std::string what_;
  std::chrono::steady_clock::time_point next_;
  bool shown_ = false;
};

/// Runs work from the terminal: interrupts are caught and end it early, and `what` is said to have
/// come so far on standard error until the control is gone.
properties::RunControl run_control(std::string what, int threads = 1);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_TERMINAL_H_
