#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/text.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/report/json.h"
#include "tools/report/spelling.h"

namespace raycheck::tools {

/// A view of a graded class, for instructors: printed with `--format NAME`, or written to the file
/// NAME beside the submissions' folders.
struct ClassView {
  std::string_view name;
  std::string (*render)(const ClassGrade&);
};

std::string class_text(const ClassGrade& graded);
std::string class_csv(const ClassGrade& graded);
std::string class_json(const ClassGrade& graded);
std::string class_page(const ClassGrade& graded);

/// The formats that the command prints; the first is the default.
inline constexpr ClassView kPrintedViews[] = {
    {"text", class_text}, {"json", class_json}, {"csv", class_csv}};
/// What students may see of their grades.
std::string try_text(const ClassGrade& graded);
/// Whether every item that students may see and that was asked holds, of all submissions.
bool holds_for_students(const ClassGrade& graded);

/// A graded class whose submissions were only built and tried.
std::string probe_text(const ClassGrade& probed);
std::string probe_json(const ClassGrade& probed);
inline constexpr ClassView kProbeViews[] = {{"text", probe_text}, {"json", probe_json}};
inline constexpr ClassView kClassFiles[] = {{"grades.csv", class_csv}, {"index.html", class_page}};

/// A submission's complete grade as JSON, including what is withheld from students.
Json record_json(const SubmissionGrade& grade);
/// A form of driver files, by the keys of a rubric's [driver].
Json driver_json(const DriverForm& form);
Json refusal_json(const Refusal& refusal);

/// A format of results.json, a file of each submission for a course's system; chosen by `--format
/// NAME`.
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

/// A student's page of all items. It is self-contained except for links to the page of figures.
std::string report_page(const StudentGrade& grade);

/// Points with at most two decimals, without trailing zeros: "7", "2.5".
std::string points_text(double points);

/// "the scene frame.toml", "random case 7 of the source course"
std::string origin_text(const CaseOrigin& origin);

/// "class, pixel (3, 4), sphere 0: missed"
std::string answer_text(const FailingCase& failing);
/// The numbers of the answer, or "miss"; empty if there are no numbers or they are withheld.
std::string got_text(const FailingCase& failing);
std::string exact_text(const FailingCase& failing);
/// The step at which the failing case goes wrong, or empty.
std::string step_text(const FailingCase& failing);

/// The reason as a text; empty if there is none.
std::string reason_text(const ItemReason& reason);

/// What to do about a failing item: the rubric's hint, unless the program fails or lacks a
/// function.
std::string hint_text(const Item& item, const ItemGrade& grade);

/// "the far root is taken for the near one; this explains all 12 wrong answers examined"
std::string mistake_text(const ItemGrade& grade, const ExplainingMistake& mistake);

/// The mistake that explains most items; empty if no mistake is known.
std::string mistake_text(const SubmissionGrade& grade);

/// "holds over 40 cases", "fails 3 of 40 cases", "left out: it needs ..."
std::string state_text(const ItemGrade& grade);

/// The score without bonus; "-" if the submission could not be judged and gets no points.
std::string score_text(const SubmissionGrade& grade);
/// " of 100, bonus 7.5"; of an item: " of 10 (bonus)"
std::string of_points_text(const SubmissionGrade& grade);
std::string of_points_text(const ItemGrade& grade);

/// "could not be judged: 'make' exited with 2". Domain: a submission that could not be judged.
std::string not_judged_text(const SubmissionGrade& grade);

/// Why nothing could be run, with the compiler's output.
std::string refusal_text(const Refusal& refused);

/// "not shown, but in the score: 2 items"; empty if all are shown.
std::string unlisted_text(const StudentGrade& grade);

/// The sentence of the law that a failing case breaks.
std::string law_text(const FailingCase& failing);
/// The failing case as a TOML scene; as a driver file, empty if it has no camera.
std::string scene_text(const FailingCase& failing);
std::string driver_file_text(const FailingCase& failing, const Preparation& found);

/// The total times of the submissions: "built in 3.2 s, 4 from the store, judged in 0.5 s"; empty
/// if none was run.
std::string times_text(const ClassGrade& graded);

/// The isolation of submissions: "isolated by: seccomp, bubblewrap", and why other layers are
/// missing on this machine.
std::string isolation_text(const LayersHere& isolation);

/// The first values, as `write` writes them, and how many more there are: "a, b and 3 more".
template <class Value, class Write>
std::string first_text(const std::vector<Value>& values, std::size_t most, const Write& write) {
  const std::span<const Value> first(values.data(), std::min(values.size(), most));
  return scene::joined(first, ", ", write) +
         (values.size() > most ? fmt::format(" and {} more", values.size() - most) : "");
}

/// A name without terminal control sequences.
std::string line_text(const std::string& name);

/// One line for each item of a submission, and its mistake.
std::string submission_text(const SubmissionGrade& grade);

/// The question and the outcome of item k, in lines.
std::string item_text(const StudentGrade& all, std::size_t k);

/// A command line, and its purpose.
struct HomeCommand {
  std::string purpose;
  std::string words;
};

/// Commands that build the submission as raycheck did and repeat the failing case of item k, whose
/// files must lie beside the submission's. Empty if there is no failing case.
std::vector<HomeCommand> commands_for_case(const StudentGrade& grade, std::size_t k);

/// Whether item k has a figure: it is judged by functions and fails on a case whose exact answer
/// the student may see.
bool has_figure(const StudentGrade& grade, std::size_t k);
bool has_figures(const StudentGrade& grade);
/// The page of all figures, made from stored answers without running anything. Domain:
/// has_figures().
std::string figures_page(const StudentGrade& grade);

/// A self-contained page, for narrow and wide screens.
std::string page(std::string_view title, std::string_view body);

/// Text in a URL: every byte except letters, digits and those in `plain` is percent-encoded.
std::string percent_encoded(std::string_view text, std::string_view plain = "");

/// A link that saves a text as a file.
std::string download(std::string_view file, std::string_view text);

/// "12 of 441 pixels differ: yours shows no sphere", where `whose` is "yours"; empty if there are
/// no pictures, or the exact one is withheld.
std::string difference_text(const FailingCase& failing, std::string_view whose = "yours");

/// The submission's picture, the expected picture and their differences, side by side. Spheres have
/// colours that colour-blind readers can distinguish; differences are marks. Withheld pictures are
/// omitted; empty if there are no pictures.
std::string pictures_html(const FailingCase& failing, std::string_view whose = "yours");

}  // namespace raycheck::tools
