#include <memory>
#include <stdexcept>
#include <string>

#include "tools/arguments.h"
#include "tools/commands.h"
#include "tools/rubric/rubric.h"

namespace raycheck::tools {
namespace {

struct RubricArguments {
  std::string name, out;
};

std::string rubric_report(const RubricArguments& arguments) {
  if (arguments.name.empty()) {
    if (!arguments.out.empty()) throw std::invalid_argument("--out: name the rubric to copy");
    return rubrics_text(list_rubrics());
  }
  if (arguments.out.empty()) return rubric_file(arguments.name);
  return copied_text(copy_rubric(arguments.name, arguments.out));
}

}  // namespace

CommandRun add_rubric(CLI::App& command) {
  const auto given = std::make_shared<RubricArguments>();
  command.add_option("NAME", given->name, "lecture7");
  command.add_option("--out", given->out, "the folder that takes a copy of it and its scenes");
  return [given] {
    print_report(rubric_report(*given));
    return kExitNothingFound;
  };
}

}  // namespace raycheck::tools
