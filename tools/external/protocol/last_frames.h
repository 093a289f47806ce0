#pragma once

// Where in its own code a library was when it died or threw. Runs in the candidate's process.

#include <exception>
#include <string>

namespace raycheck::tools {

/// From now on what dies of SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP or SIGABRT first writes a line
/// to `descriptor`, and then dies of the same signal: "frames OFFSET OFFSET ...", the innermost
/// frames of the library that is followed, at most kMostFrames (frames.h), as hexadecimal offsets
/// in its file. Nothing is written where there are none. On a stack of its own in the thread that
/// calls this, so that a stack that is used up has its line, too.
void report_deaths(int descriptor);

/// Whose frames these are.
/// Domain: what dlopen() returned.
void follow(void* library);

/// The same line of where an exception was thrown; empty where that is not known: it was thrown by
/// none of the library's code, or others were thrown after it.
std::string frames_of_throw(const std::exception& error);

}  // namespace raycheck::tools
