#pragma once

#include <string>

namespace raycheck::tools {

/// The rubrics shipped with raycheck, a line each: name, title, how many items.
std::string rubrics_text();

/// The unchanged text of one's file.
/// Errors: std::invalid_argument if none has that name.
std::string rubric_file(const std::string& name);

/// Copies one and the scenes that it names to a folder; what was written, in a line.
/// Errors: as rubric_file(); std::invalid_argument if a file exists already, or cannot be written.
std::string copy_rubric(const std::string& name, const std::string& out);

}  // namespace raycheck::tools
