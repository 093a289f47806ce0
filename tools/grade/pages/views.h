#pragma once

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

std::string class_text(const ClassGrade& graded);
std::string class_csv(const ClassGrade& graded);
std::string class_json(const ClassGrade& graded);
std::string class_page(const ClassGrade& graded);

/// What the command can print; the first by default.
inline constexpr ClassView kPrintedViews[] = {
    {"text", class_text}, {"json", class_json}, {"csv", class_csv}};
inline constexpr ClassView kClassFiles[] = {{"grades.csv", class_csv}, {"index.html", class_page}};

/// The file results.json of each submission for a course's system, with `--format NAME`.
struct ResultsFormat {
  std::string_view name;
  HiddenBy hidden_by;
  std::string (*render)(const StudentGrade&);
};

std::string gradescope_results(const StudentGrade& grade);
std::string prairielearn_results(const StudentGrade& grade);

inline constexpr ResultsFormat kResultsFormats[] = {
    {"gradescope", HiddenBy::kOtherSystem, gradescope_results},
    {"prairielearn", HiddenBy::kUs, prairielearn_results}};

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
