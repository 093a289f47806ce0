#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace raycheck::tools {

/// A rubric shipped with raycheck.
struct ShippedRubric {
  std::string name;  ///< "lecture7"
  std::string title;
  std::size_t items = 0;
};
std::vector<ShippedRubric> list_rubrics();

/// The unchanged text of its file.
/// Errors: std::invalid_argument if none has that name.
std::string rubric_file(const std::string& name);

/// What was copied: a rubric and the scenes that it names.
struct CopiedRubric {
  std::string path;
  std::size_t scenes = 0;
};
/// Errors: as rubric_file(); std::invalid_argument if a file exists already, or cannot be written.
CopiedRubric copy_rubric(const std::string& name, const std::string& out);

std::string rubrics_text(const std::vector<ShippedRubric>& rubrics);
std::string copied_text(const CopiedRubric& copied);

}  // namespace raycheck::tools
