#include <memory>

#include "tools/edge.h"
#include "tools/grade/grade.h"

namespace raycheck::tools {
namespace {

struct TryArguments {
  GradeOptions options = {.for_student = true, .sandbox = Sandbox::kAvailable};
  SandboxArguments sandbox;
};

int run_try(const TryArguments& arguments) {
  GradeOptions options = arguments.options;
  options.sandbox = sandbox_of(arguments.sandbox);
  const ClassGrade graded = grade(options, run_control("submissions"));
  print_report(try_text(graded));
  return exit_code(graded.interrupted, !holds_for_students(graded), true);
}

}  // namespace

CommandRun add_try(CLI::App& command) {
  const auto given = std::make_shared<TryArguments>();
  TryArguments& arguments = *given;
  command
      .add_option("RUBRIC", arguments.options.rubric,
                  "a TOML file, or one that comes with raycheck: lecture7.toml")
      ->required();
  command.add_option("SUBMISSION", arguments.options.submissions, "folders or files to hand in")
      ->required();
  command.add_option(
      "--out", arguments.options.out,
      "a folder for the results: the page and the failing cases are written to OUT/NAME/");
  add_rubric_dialect(command, arguments.options.dialect);
  add_seed(command, arguments.options.seed);
  add_sandbox(command, arguments.sandbox);
  return [given] { return run_try(*given); };
}

}  // namespace raycheck::tools
