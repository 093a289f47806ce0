#pragma once

// The line in which raycheck-worker says where in its own code a library died or threw: "frames"
// and the innermost frames first, hexadecimal offsets in the library's file. What writes it runs in
// the candidate's process.

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

inline constexpr std::string_view kFramesWord = "frames";
/// Frames of library headers may lie inside those of the candidate, as in a comparison called by
/// std::sort; this many frames reach its own code.
inline constexpr std::size_t kMostFrames = 16;
/// An offset takes a space and at most 16 digits.
inline constexpr std::size_t kMostFramesLine = kFramesWord.size() + 17 * kMostFrames + 1;

/// The frames in the last such line of what a worker wrote; empty without such a line, or if it is
/// malformed, since the candidate may write there, too.
std::vector<std::uint64_t> frames_in(std::string_view text);

/// From now on what dies of SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP or SIGABRT first writes a line
/// to `descriptor`, and then dies of the same signal: "frames OFFSET OFFSET ...", the innermost
/// frames of the library that is followed, at most kMostFrames, as hexadecimal offsets
/// in its file. Nothing is written where there are none. On a stack of its own in the thread that
/// calls this, so that a stack that is used up has its line, too.
void report_deaths(int descriptor);

/// Whose frames to report.
/// Domain: what dlopen() returned.
void follow(void* library);

/// The same line for where an exception was thrown; empty if unknown: it was not thrown by the
/// library's code, or others were thrown since.
std::string frames_of_throw(const std::exception& error);

}  // namespace raycheck::tools
