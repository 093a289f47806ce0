#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "scene/files/file_text.h"
#include "tools/commands.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

struct RubricArguments {
  std::string name, out;
};

std::string rubric_report(const RubricArguments& arguments) {
  if (!arguments.out.empty()) return copy_rubric(arguments.name, arguments.out);
  if (!arguments.name.empty()) return scene::file_text(rubric_path(arguments.name));
  return rubrics_text() +
         "`raycheck rubric NAME` prints a rubric; --out FOLDER copies it with its scenes.\n";
}

}  // namespace

CommandRun add_rubric(CLI::App& command) {
  const auto given = std::make_shared<RubricArguments>();
  CLI::Option* const name =
      command.add_option("NAME", given->name, "the name of a rubric: lecture7");
  command.add_option("--out", given->out, "copy the rubric and its scenes to this folder")
      ->needs(name);
  return [given] {
    print_report(rubric_report(*given));
    return kExitNothingFound;
  };
}

}  // namespace raycheck::tools
