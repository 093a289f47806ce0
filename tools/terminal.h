#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "properties/run_control.h"

namespace raycheck::tools {

/// Opens closed descriptors among 0, 1 and 2 on something that can be neither read nor written, so
/// that no file takes the number of a standard stream. To be called first in a program.
void hold_standard_streams();

/// From now on SIGINT, SIGTERM and SIGHUP raise a flag instead of ending the program, and a pipe
/// that closes makes writing fail. A second SIGINT ends it; of the others terminals and services
/// send several. A SIGHUP that is ignored (nohup) stays so.
void catch_signals();
bool interrupted();
/// The signal that was caught first; 0 before.
int caught_signal();

/// What write_out() throws when nobody reads standard output any more.
struct ClosedPipe {};
/// Writes to standard output. After an interrupt, gives up on a reader that does not read for a
/// second. Errors: ClosedPipe; std::runtime_error; scene::Interrupted when it gives up.
void write_out(std::string_view text);
bool has_written_out();
/// Reads what there is on standard input, at most `most` bytes; nothing at its end.
/// Errors: std::runtime_error; scene::Interrupted.
std::string read_in(std::size_t most);

/// Whether standard output takes colours: a terminal, and NO_COLOR is not set.
bool stdout_takes_colours();

/// Runs work from the terminal: the signals that are caught end it early, and `what` is said to
/// have come so far on standard error until the control is gone.
properties::RunControl run_control(std::string what, int threads = 1);

}  // namespace raycheck::tools
