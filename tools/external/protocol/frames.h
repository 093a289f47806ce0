#pragma once

// The line in which raycheck-worker reports where a library crashed or threw: "frames", then
// hexadecimal offsets in the library's file, the innermost frame first. It is written in the
// candidate's process.

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

inline constexpr std::string_view kFramesWord = "frames";
/// The innermost frames may belong to library headers, as in a comparison called by std::sort; this
/// many frames reach the candidate's code.
inline constexpr std::size_t kMostFrames = 16;
/// Each offset takes a space and at most 16 digits.
inline constexpr std::size_t kMostFramesLine = kFramesWord.size() + 17 * kMostFrames + 1;

/// The frames in the last such line of a worker's output; empty if there is no such line or it is
/// malformed (the candidate may write there, too).
std::vector<std::uint64_t> frames_in(std::string_view text);

/// Installs handlers for SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP and SIGABRT that write a line
/// "frames OFFSET OFFSET ..." to `descriptor` before the process dies of the signal: the innermost
/// frames of the followed library, at most kMostFrames, as hexadecimal offsets in its file; nothing
/// without such frames. The handlers use a separate stack in the calling thread, so that stack
/// overflows are reported, too.
void report_deaths(int descriptor);

/// The library whose frames are reported. Domain: a handle from dlopen().
void follow(void* library);

/// The same line for the place where an exception was thrown; empty if it was not thrown by the
/// library's code, or if another exception was thrown since.
std::string frames_of_throw(const std::exception& error);

}  // namespace raycheck::tools
