#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "properties/run_control.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// If descriptor 0, 1 or 2 is closed, opens it on something that can be neither read nor written,
/// so that no file gets the number of a standard stream. To be called first in a program.
void hold_standard_streams();

/// From now on, SIGINT, SIGTERM and SIGHUP set a flag instead of ending the program, and writing to
/// a closed pipe fails. A second SIGINT ends the program; further SIGTERMs and SIGHUPs do not,
/// since terminals and services may send several. If SIGHUP is ignored (nohup), it stays ignored.
void catch_signals();
bool interrupted();
/// The first signal that was caught; 0 if there was none.
int caught_signal();

/// Thrown if the reader of standard output has closed the pipe.
struct ClosedPipe {};
bool has_written_out();

/// Whether standard output takes colours: a terminal, and NO_COLOR is not set.
bool stdout_takes_colours();

/// Prints text, escaped by scene::visible, to standard error, so that no file, candidate or name
/// controls the terminal. If standard error is closed or full, the program goes on, so that the
/// report is not lost.
void print_error(const std::string& text);
void print_warnings(const std::vector<std::string>& warnings);
/// Prints a report to standard output. If it cannot be written, throws ClosedPipe or
/// std::runtime_error; if, after an interrupt, the output is blocked for a second,
/// scene::Interrupted. `colours`: whether to keep colours.
void print_report(const std::string& report, bool colours = false);
/// Prints lines that the log of a GitHub workflow executes. Throws as print_report().
void print_commands(const std::string& commands);

/// Prints a report in the format of this name.
/// Domain: a name that add_format accepts.
template <class Report, std::size_t N>
void print_view(const View<Report> (&views)[N], std::string_view format, const Report& report) {
  const bool colours = stdout_takes_colours();
  for (const View<Report>& view : views) {
    if (view.name != format) continue;
    print_report(view.render(report, {colours}), colours);
  }
}

/// Control for work run from a terminal: caught signals end it early, and standard error shows the
/// progress of `what` while the control lives.
properties::RunControl run_control(std::string what, int threads = 1);

}  // namespace raycheck::tools
