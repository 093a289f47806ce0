#include <fmt/core.h>

#include <algorithm>

#include "tools/grade/pages.h"
#include "tools/grade/words.h"
#include "tools/report/format.h"

namespace raycheck::tools {

std::string points_text(double points) {
  std::string text = fmt::format("{:.2f}", points);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string mistake_text(const SubmissionGrade& grade) {
  // How many items a sentence explains, the counts that follow it aside.
  std::vector<std::pair<std::string, int>> counts;
  for (const ItemGrade& item : grade.items) {
    for (const std::string& sentence : item.sentences) {
      const std::string mistake = sentence.substr(0, sentence.rfind(": "));
      const auto known = std::find_if(counts.begin(), counts.end(),
                                      [&](const auto& entry) { return entry.first == mistake; });
      if (known == counts.end()) {
        counts.emplace_back(mistake, 1);
      } else {
        ++known->second;
      }
    }
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? "" : most->first;
}

std::string state_text(const ItemGrade& grade) {
  if (grade.state == kHolds) {
    return fmt::format("holds over {}, {}", count_text(grade.cases, "case"),
                       count_text(grade.comparisons, "comparison"));
  }
  if (grade.state != kFails) return grade.state + ": " + grade.reason;
  std::string text =
      fmt::format("fails {} of {}", grade.cases - grade.held, count_text(grade.cases, "case"));
  if (!grade.reason.empty()) text += fmt::format(" ({})", grade.reason);
  return text;
}

std::string item_text(const Item& item, const ItemGrade& grade) {
  std::string text;
  const auto line = [&](const std::string& words) { text += words + "\n"; };
  if (!item.asks.empty()) line("asked: " + item.asks);
  line(state_text(grade));
  for (const std::string& sentence : grade.sentences) line("mistake: " + sentence);
  for (const FailingCase& failing : grade.failing) {
    line("the law: " + failing.law);
    line(failing.what);
    if (!failing.actual.empty()) line("  got   " + failing.actual);
    if (!failing.expected.empty()) line("  exact " + failing.expected);
    if (!failing.step.empty()) line("goes wrong at: " + failing.step);
  }
  if (grade.state == kFails && !item.hint.empty()) line("hint: " + item.hint);
  for (const FailingCase& failing : grade.failing) {
    line(fmt::format("the smallest failing case (from {}), a scene for `raycheck check`:",
                     failing.origin));
    text += failing.scene;
    if (!failing.driver.empty()) {
      line("the same as a driver file:");
      text += failing.driver;
    }
  }
  return text;
}

std::string class_csv(const ClassGrade& graded) {
  const auto quoted = [](const std::string& text) {
    // What a spreadsheet would take for a formula is text.
    std::string result = text.find_first_of("=+-@") == 0 ? "'" + text : text;
    for (std::size_t at = 0; (at = result.find('"', at)) != std::string::npos; at += 2) {
      result.insert(at, 1, '"');
    }
    return '"' + result + '"';
  };
  std::string text = "submission,score,points";
  for (const Item& item : graded.rubric.items) text += "," + quoted(item.name);
  text += ",note\n";
  for (const SubmissionGrade& grade : graded.submissions) {
    text += fmt::format("{},{},{}", quoted(grade.name), points_text(grade.score),
                        points_text(grade.points));
    for (const ItemGrade& item : grade.items) {
      text += "," + (item.state == kNotAsked ? "" : points_text(item.score));
    }
    const std::string note = !grade.refused.empty()
                                 ? grade.refused.substr(0, grade.refused.find('\n'))
                             : grade.finished ? mistake_text(grade)
                                              : "interrupted";
    text += "," + (note.empty() ? "" : quoted(note)) + "\n";
  }
  return text;
}

namespace {

/// A name without what a terminal would obey.
std::string line_text(const std::string& name) {
  std::string text = plain_text(name);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, '?');
  return text;
}

/// A line a submission, and its mistake.
std::string submission_lines(const ClassGrade& graded) {
  std::size_t width = 0;
  for (const SubmissionGrade& grade : graded.submissions) {
    width = std::max(width, line_text(grade.name).size());
  }
  std::string text;
  for (const SubmissionGrade& grade : graded.submissions) {
    text += fmt::format("{:<{}}  {:>6} of {}", line_text(grade.name), width,
                        points_text(grade.score), points_text(grade.points));
    std::string failing;
    for (const ItemGrade& item : grade.items) {
      if (item.state == kFails) failing += (failing.empty() ? "" : ", ") + item.name;
    }
    if (!grade.refused.empty()) {
      text += "  " + grade.refused.substr(0, grade.refused.find('\n'));
    } else if (!grade.finished) {
      text += "  not finished";
    } else if (!failing.empty()) {
      text += "  fails " + failing;
    }
    text += "\n";
    const std::string mistake = mistake_text(grade);
    if (!mistake.empty()) text += fmt::format("{:<{}}    {}\n", "", width, mistake);
  }
  return text;
}

/// A line an item, for who looks at one submission.
std::string item_lines(const Rubric& rubric, const SubmissionGrade& grade) {
  std::string text = fmt::format("{}: {} of {}\n", line_text(grade.name), points_text(grade.score),
                                 points_text(grade.points));
  if (!grade.refused.empty()) return text + grade.refused + "\n";
  std::size_t width = 0;
  for (const Item& item : rubric.items) width = std::max(width, item.name.size());
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const ItemGrade& item = grade.items[k];
    const std::string of = item.state == kNotAsked
                               ? ""
                               : fmt::format(" of {}{}", points_text(rubric.items[k].points),
                                             item.bonus ? " (bonus)" : "");
    text +=
        fmt::format("  {:<{}}  {:>5}{}  {}\n", item.name, width,
                    item.state == kNotAsked ? "-" : points_text(item.score), of, state_text(item));
  }
  const std::string mistake = mistake_text(grade);
  if (!mistake.empty()) text += "  " + mistake + "\n";
  return text;
}

}  // namespace

std::string class_text(const ClassGrade& graded) {
  std::string text = graded.rubric.title + "\n";
  const bool is_one = graded.submissions.size() == 1;
  text += is_one ? item_lines(graded.rubric, graded.submissions.front()) : submission_lines(graded);
  if (is_one && !graded.out.empty()) {
    text +=
        fmt::format("see {}/{}/report.html\n", graded.out, line_text(graded.submissions[0].name));
  }
  if (graded.interrupted) {
    text += "INTERRUPTED: the same command goes on where it was cut.\n";
  }
  text += count_text(graded.submissions.size(), "submission") + " graded";
  if (graded.reused > 0) text += fmt::format(", {} of them by an earlier run", graded.reused);
  return text + "\n";
}

}  // namespace raycheck::tools
