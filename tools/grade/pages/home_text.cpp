#include <fmt/core.h>

#include <boost/algorithm/string/replace.hpp>
#include <utility>

#include "scene/number.h"
#include "tools/grade/pages/wording.h"
#include "tools/report/words.h"
#include "tools/view/view_words.h"

namespace raycheck::tools {
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
      fmt::format("raycheck check {}.toml{}", name, candidate_words(program->text()));
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
