#pragma once

#include <cstdint>
#include <string>

#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// Writes the zip file of a Gradescope autograder: setup.sh and run_autograder, the rubric with its
/// scenes, and raycheck with the libraries that it needs besides those of C and C++.
/// Errors: std::invalid_argument or std::runtime_error naming the file.
void write_package(const Rubric& rubric, std::uint64_t seed, const std::string& path);

}  // namespace raycheck::tools
