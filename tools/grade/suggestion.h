#pragma once

#include <string>

#include "tools/grade/probe.h"

namespace raycheck::tools {

/// A part of a rubric, in TOML, under which the submissions run as the dry run made them run: the
/// table [driver] with the form that most read, and of those that are built as they come each
/// [[form]] that says so in words of its own and fits no others, then the form that fits the rest.
/// Empty: nothing runs that it could be made of.
std::string suggestion(const ProbeReport& report);

}  // namespace raycheck::tools
