#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "scene/text.h"
#include "tools/grade/pages/views.h"
#include "tools/grade/results/result.h"
#include "tools/report/json.h"
#include "tools/report/spelling.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// "time is up after 60 s: robustness not judged"; empty if every item was asked.
std::string time_up_text(const SubmissionGrade& grade) {
  std::string items;
  double seconds = 0;
  for (const ItemGrade& item : grade.items) {
    if (item.reason.kind != ItemReason::Kind::kTimeUp) continue;
    seconds = item.reason.seconds;
    items += (items.empty() ? "" : ", ") + item.name;
  }
  if (items.empty()) return "";
  return fmt::format("time is up after {} s: {} not judged", seconds, items);
}

/// A line for each submission, with its mistake.
std::string submission_lines(const ClassGrade& graded) {
  std::size_t width = 0;
  for (const SubmissionGrade& grade : graded.submissions) {
    width = std::max(width, line_text(grade.name).size());
  }
  std::string text;
  for (const SubmissionGrade& grade : graded.submissions) {
    const bool is_judged = could_be_judged(grade);
    text += fmt::format("{:<{}}  {:>6}{}", line_text(grade.name), width, score_text(grade),
                        of_points_text(grade));
    std::string failing;
    for (const ItemGrade& item : grade.items) {
      if (item.state == ItemState::kFails) failing += (failing.empty() ? "" : ", ") + item.name;
    }
    if (!is_judged) {
      text += "  " + not_judged_text(grade);
    } else if (!grade.finished) {
      text += "  not finished";
    } else if (!failing.empty()) {
      text += "  fails " + failing;
    }
    text += "\n";
    const auto line = [&](const std::string& words) {
      if (!words.empty()) text += fmt::format("{:<{}}    {}\n", "", width, words);
    };
    if (is_judged) line(time_up_text(grade));
    if (!is_judged && !graded.out.empty()) {
      line(fmt::format("see {}/{}/{}", graded.out, line_text(grade.name), kReportFile));
    }
    line(mistake_text(grade));
    for (const std::string& note : grade.notes) line(line_text(note));
  }
  return text;
}

}  // namespace

/// The table that the command prints.
std::string class_text(const ClassGrade& graded) {
  std::string text = graded.rubric.title + "\n";
  if (graded.isolation) text += isolation_text(*graded.isolation) + "\n";
  const bool is_one = graded.submissions.size() == 1;
  text += is_one ? submission_text(graded.submissions.front()) : submission_lines(graded);
  if (is_one && !graded.out.empty()) {
    text += fmt::format("see {}/{}/{}\n", graded.out, line_text(graded.submissions[0].name),
                        kReportFile);
  }
  if (graded.interrupted) {
    text += "INTERRUPTED: run the same command again to continue.\n";
  }
  if (!graded.isolation) {  // no submission was given
    return text + "graded: raycheck's own " +
           scene::joined(graded.submissions, " and ", &SubmissionGrade::name) + "\n";
  }
  const std::size_t all = graded.submissions.size();
  const std::size_t not_judged = submissions_that(graded, false).size();
  text += not_judged == 0 ? fmt::format("{} graded", count_text(all, "submission"))
                          : fmt::format("{} of {} graded; {} could not be judged", all - not_judged,
                                        count_text(all, "submission"), not_judged);
  if (graded.not_graded() > 0) {
    text += fmt::format(
        ", {} of them for reasons outside the submission: run the same command to retry",
        graded.not_graded());
  }
  if (const std::string times = times_text(graded); !times.empty()) text += " (" + times + ")";
  return text + "\n";
}

namespace {

std::string csv_note(const SubmissionGrade& grade) {
  if (!could_be_judged(grade)) return csv_cell(not_judged_text(grade));
  if (!grade.finished) return "interrupted";
  const std::string time_up = time_up_text(grade), mistake = mistake_text(grade);
  const std::string note = time_up + (time_up.empty() || mistake.empty() ? "" : "; ") + mistake;
  return note.empty() ? "" : csv_cell(note);
}

}  // namespace

/// A row for each submission, a column for each item. A submission that could not be judged has
/// only the points that the rubric gives such submissions.
std::string class_csv(const ClassGrade& graded) {
  std::string text = "submission,score,points";
  for (const Item& item : graded.rubric.items) text += "," + csv_cell(item.name);
  text += ",note\n";
  for (const SubmissionGrade& grade : graded.submissions) {
    const bool is_judged = could_be_judged(grade);
    const bool has_score = is_judged || grade.score > 0;
    text += fmt::format("{},{},{}", csv_cell(grade.name), has_score ? points_text(grade.score) : "",
                        points_text(grade.points));
    for (const ItemGrade& item : grade.items) {
      const bool has_points = is_judged && item.state != ItemState::kNotAsked;
      text += "," + (has_points ? points_text(item.score) : "");
    }
    text += "," + csv_note(grade) + "\n";
  }
  return text;
}

std::string class_json(const ClassGrade& graded) {
  Json json = json_header("grade");
  json["rubric"] = graded.rubric.title;
  json["interrupted"] = graded.interrupted;
  json["not_graded"] = graded.not_graded();
  json["submissions"] = list_json(graded.submissions, record_json);
  return json_text(json);
}

namespace {

std::vector<StudentGrade> shown_of(const ClassGrade& graded) {
  std::vector<StudentGrade> shown;
  for (const SubmissionGrade& grade : graded.submissions) {
    shown.push_back(student_grade(graded.rubric, grade, HiddenBy::kUs));
  }
  return shown;
}

/// The lines that `grade` prints for one submission, then details of the items that fail. `out`:
/// the folder of the results; or empty.
std::string try_text(const StudentGrade& shown, const std::string& out) {
  std::string text = submission_text(shown.submission);
  if (shown.unlisted > 0) text += "  " + unlisted_text(shown) + "\n";
  for (std::size_t k = 0; k < shown.items.size(); ++k) {
    const ItemGrade& item = shown.submission.items[k];
    // For items that were not answered, the line above is complete.
    const bool has_more = item.failing || item.reason.kind != ItemReason::Kind::kUnanswered;
    if (item.state != ItemState::kFails || !has_more) continue;
    text += "\n" + shown.items[k]->name + "\n" + indented(item_text(shown, k), "  ");
  }
  if (!out.empty()) {
    const bool has_cases = std::ranges::any_of(
        shown.submission.items, [](const ItemGrade& item) { return item.failing.has_value(); });
    text += fmt::format("\nwrote {}/report.html{}\n",
                        (std::filesystem::path(out) / shown.submission.name).string(),
                        has_cases ? ", and the smallest failing cases beside it" : "");
  }
  return text;
}

}  // namespace

bool holds_for_students(const ClassGrade& graded) {
  const auto item_holds = [](const ItemGrade& item) {
    return item.state == ItemState::kHolds || item.state == ItemState::kNotAsked;
  };
  return std::ranges::all_of(shown_of(graded), [&](const StudentGrade& one) {
    return could_be_judged(one.submission) && std::ranges::all_of(one.submission.items, item_holds);
  });
}

std::string try_text(const ClassGrade& graded) {
  const auto text_of = [&](const StudentGrade& one) { return try_text(one, graded.out); };
  return graded.rubric.title + "\n" + scene::joined(shown_of(graded), "\n", text_of) +
         (graded.interrupted ? "INTERRUPTED: these are the results so far.\n" : "");
}

}  // namespace raycheck::tools
