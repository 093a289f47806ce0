#include <fmt/core.h>

#include <string_view>
#include <utility>

#include "scene/number.h"
#include "tools/grade/pages/home.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

std::string replaced(std::string text, std::string_view what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
    text.replace(at, what.size(), by);
  }
  return text;
}

}  // namespace

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
    commands.push_back({"Draw it", replaced(replaced(program->what, "{scene}", name + ".txt"),
                                            "{image}", "out.ppm")});
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
