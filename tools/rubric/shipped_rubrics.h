#pragma once

#include <string>

namespace raycheck::tools {

/// A line for each shipped rubric: name, title, number of items.
std::string rubrics_text();

/// The text of a shipped rubric's file.
/// Errors: std::invalid_argument if there is no such rubric.
std::string rubric_file(const std::string& name);

/// Copies a shipped rubric and its scenes to a folder; returns a line about what was written.
/// Errors: as rubric_file(); std::invalid_argument if a file already exists, or cannot be written.
std::string copy_rubric(const std::string& name, const std::string& out);

}  // namespace raycheck::tools
