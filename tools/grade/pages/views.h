#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tools/grade/results/redaction.h"
#include "tools/grade/results/result.h"

namespace raycheck::tools {

/// A view of a graded class, for instructors: what the command prints under `--format NAME`, or
/// what lies in the file NAME beside the submissions' folders.
struct ClassView {
  std::string_view name;
  std::string (*render)(const ClassGrade&);
};

/// What the command prints; the first where nothing else is asked for.
std::span<const ClassView> printed_views();
std::span<const ClassView> class_files();

/// What a course's system reads of each submission, results.json, under `--format NAME`.
struct ResultsFormat {
  std::string_view name;
  HiddenBy hidden_by;
  std::string (*render)(const StudentGrade&);
};
std::span<const ResultsFormat> results_formats();

/// The names of a student's pages.
inline constexpr const char* kReportFile = "report.html";
inline constexpr const char* kFiguresFile = "figures.html";

/// What a student reads: a page of all items, self-contained but for its links to the other one,
/// and figures of the failing cases of functions; empty where there are none.
struct StudentPages {
  std::string report, figures;
};
StudentPages student_pages(const StudentGrade& grade);

}  // namespace raycheck::tools
