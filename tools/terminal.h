#ifndef RAYCHECK_TOOLS_TERMINAL_H_
#define RAYCHECK_TOOLS_TERMINAL_H_

#include <chrono>
#include <string>
#include <string_view>

namespace raycheck::tools {

/// Makes Ctrl-C (or SIGTERM) raise a flag instead of ending the program; a second one ends it.
void catch_interrupts();
bool interrupted();

/// Whether standard output takes colours: a terminal, and NO_COLOR is not set.
bool stdout_takes_colours();

/// `text` in red, where colours are taken.
std::string red(std::string_view text, bool colours);

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

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_TERMINAL_H_
