#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "properties/run_control.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// Opens closed descriptors among 0, 1 and 2 on something that can be neither read nor written, so
/// that no file takes the number of a standard stream. To be called first in a program.
void hold_standard_streams();

/// From now on SIGINT, SIGTERM and SIGHUP raise a flag instead of ending the program, and a pipe
/// that closes makes writing fail. A second SIGINT ends it; terminals and services may send several
/// of the others. A SIGHUP that is ignored (nohup) stays so.
void catch_signals();
bool interrupted();
/// The first signal that was caught; 0 if none.
int caught_signal();

/// Thrown if the reader of standard output has closed the pipe.
struct ClosedPipe {};
bool has_written_out();

/// Whether standard output takes colours: a terminal, and NO_COLOR is not set.
bool stdout_takes_colours();

/// Prints text escaped by scene::visible, so that no file, candidate or name controls the terminal.
/// Standard error may be closed or full: that must not lose the report.
void print_error(const std::string& text);
void print_warnings(const std::vector<std::string>& warnings);
/// A lost report must not look like a good one: throws ClosedPipe, std::runtime_error, or, if after
/// an interrupt the output is blocked for a second, scene::Interrupted. `colours`: keeps colours.
void print_report(const std::string& report, bool colours = false);
/// Likewise for lines that the log of a GitHub workflow is to execute.
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
