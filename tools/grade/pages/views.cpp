#include "tools/grade/pages/views.h"

namespace raycheck::tools {

std::string class_text(const ClassGrade& graded);
std::string class_csv(const ClassGrade& graded);
std::string class_json(const ClassGrade& graded);
std::string class_page(const ClassGrade& graded);
std::string gradescope_results(const StudentGrade& grade);
std::string prairielearn_results(const StudentGrade& grade);

namespace {

constexpr ClassView kPrintedViews[] = {
    {"text", class_text}, {"json", class_json}, {"csv", class_csv}};

constexpr ClassView kClassFiles[] = {{"grades.csv", class_csv}, {"index.html", class_page}};

constexpr ResultsFormat kResultsFormats[] = {
    {"gradescope", HiddenBy::kOtherSystem, gradescope_results},
    {"prairielearn", HiddenBy::kUs, prairielearn_results}};

}  // namespace

std::span<const ClassView> printed_views() { return kPrintedViews; }
std::span<const ClassView> class_files() { return kClassFiles; }
std::span<const ResultsFormat> results_formats() { return kResultsFormats; }

}  // namespace raycheck::tools
