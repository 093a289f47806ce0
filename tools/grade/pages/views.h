#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tools/grade/results/redaction.h"
#include "tools/grade/results/result.h"

namespace raycheck::tools {

/// A view of a graded class, for instructors: what the command prints with `--format NAME`, or the
/// file NAME beside the submissions' folders.
struct ClassView {
  std::string_view name;
  std::string (*render)(const ClassGrade&);
};

/// What the command can print; the first by default.
std::span<const ClassView> printed_views();
std::span<const ClassView> class_files();

/// The file results.json of each submission for a course's system, with `--format NAME`.
struct ResultsFormat {
  std::string_view name;
  HiddenBy hidden_by;
  std::string (*render)(const StudentGrade&);
};
std::span<const ResultsFormat> results_formats();

/// The names of a student's pages.
inline constexpr const char* kReportFile = "report.html";
inline constexpr const char* kFiguresFile = "figures.html";

/// A student's pages: one of all items, self-contained except for links to the other one, and one
/// of figures of failing cases of functions; empty if there are none.
struct StudentPages {
  std::string report, figures;
};
StudentPages student_pages(const StudentGrade& grade);

}  // namespace raycheck::tools
