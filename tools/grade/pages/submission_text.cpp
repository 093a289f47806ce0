#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <utility>

#include "scene/number.h"
#include "tools/grade/pages/wording.h"
#include "tools/grade/results/result.h"
#include "tools/report/words.h"

namespace raycheck::tools {

std::string line_text(const std::string& name) {
  std::string text = plain_text(name);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, '?');
  return text;
}

namespace {

/// The dry run's remarks, one per line.
std::string notes_text(const SubmissionGrade& grade) {
  std::string text;
  for (const std::string& note : grade.notes) text += "  " + line_text(note) + "\n";
  return text;
}

}  // namespace

std::string submission_text(const std::vector<const Item*>& items, const SubmissionGrade& grade) {
  if (!could_be_judged(grade)) {
    const std::string score =
        grade.score > 0 ? score_text(grade) + of_points_text(grade) + ", " : "";
    return fmt::format("{}: {}could not be judged: {}\n{}", line_text(grade.name), score,
                       refusal_text(*grade.refused), notes_text(grade));
  }
  std::string text =
      line_text(grade.name) + ": " + score_text(grade) + of_points_text(grade) + "\n";
  const std::string mistake = mistake_text(grade);
  if (!mistake.empty()) text += "  " + mistake + "\n";
  std::size_t width = 0;
  for (const Item* item : items) width = std::max(width, item->name.size());
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const ItemGrade& item = grade.items[k];
    const std::string of =
        item.state == ItemState::kNotAsked
            ? ""
            : fmt::format(" of {}{}", points_text(items[k]->points), item.bonus ? " (bonus)" : "");
    text += fmt::format("  {:<{}}  {:>5}{}  {}\n", item.name, width,
                        item.state == ItemState::kNotAsked ? "-" : points_text(item.score), of,
                        state_text(item));
  }
  return text + notes_text(grade);
}

std::vector<HomeCommand> commands_for_case(const StudentGrade& grade, std::size_t k) {
  const ItemGrade& item = grade.submission.items[k];
  const auto& program = grade.submission.program;
  if (!item.failing || !program) return {};
  const std::string name = file_name(item.name);
  const bool is_renderer = program->kind == CandidateKind::kRenderer;
  std::vector<HomeCommand> commands;
  if (!grade.submission.build_words.empty()) {
    commands.push_back(
        {"Build it as here, in a copy of your folder", "(" + grade.submission.build_words + ")"});
  }
  if (is_renderer) {
    std::string words = boost::replace_all_copy(program->what, "{scene}", name + ".txt");
    boost::replace_all(words, "{image}", "out.ppm");
    commands.push_back({"Draw it", std::move(words)});
  }
  std::string check =
      fmt::format("raycheck check {}.toml --candidate {}", name, shell_word(program->text()));
  if (is_renderer && !(grade.submission.driver == DriverForm{})) {
    check += " --dialect " + shell_word(grade.submission.driver.name());
  }
  const auto precision = grade.submission.items[k].failing->answer.precision;
  if (is_renderer && precision != scene::Precision::kDouble) {
    check += fmt::format(" --precision {}", scene::name(precision));
  }
  const auto& pictures = grade.items[k]->pictures;
  if (is_renderer && pictures && pictures->image_change) {
    check += " --image-change " + scene::shortest(*pictures->image_change);
  }
  commands.push_back(
      {is_renderer ? "Judge every pixel of it" : "Judge every ray of it", std::move(check)});
  return commands;
}

HomeCommand command_for_all(const StudentGrade& grade) {
  return {"To grade it again, as here, in your folder",
          fmt::format("raycheck try {} .{}", shell_word(grade.rubric),
                      grade.dialect.empty() ? "" : " --dialect " + shell_word(grade.dialect))};
}

}  // namespace raycheck::tools
