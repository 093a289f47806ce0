#pragma once

// The line in which raycheck-worker, in the candidate's process, reports where a library crashed or
// threw: "frames", followed by hexadecimal offsets in the library's file, the innermost frame
// first.

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

inline constexpr std::string_view kFramesWord = "frames";
/// The innermost frames may belong to library headers, as in a comparison called by std::sort. With
/// this many frames, the line reaches the candidate's code.
inline constexpr std::size_t kMostFrames = 16;
/// Each offset takes a space and at most 16 digits.
inline constexpr std::size_t kMostFramesLine = kFramesWord.size() + 17 * kMostFrames + 1;

/// The frames in the last such line of a worker's output; empty if there is none or it is
/// malformed. (The candidate can write to this output, too.)
std::vector<std::uint64_t> frames_in(std::string_view text);

/// Installs handlers for SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP and SIGABRT. Before the process
/// dies of the signal, they write a line "frames OFFSET OFFSET ..." to `descriptor`, with the
/// innermost frames of the followed library, at most kMostFrames; no line if there are no such
/// frames. In the calling thread the handlers use a separate stack, so that stack overflows are
/// reported, too.
void report_deaths(int descriptor);

/// Sets the library whose frames are reported. Domain: a handle from dlopen().
void follow(void* library);

/// The line for the place where an exception was thrown; empty if the library's code did not throw
/// it, or if another exception was thrown since.
std::string frames_of_throw(const std::exception& error);

}  // namespace raycheck::tools
