#include <memory>

#include "tools/arguments.h"
#include "tools/command_line.h"
#include "tools/commands.h"
#include "tools/exchange/generate.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

struct GenerateArguments {
  std::string family;
  int cases = 100;
  std::uint64_t seed = 1;
};

int run_generate(const GenerateArguments& arguments) {
  const properties::ChosenSource source = source_of_questions(arguments.family);
  catch_interrupts();
  for (int k = 0; k < arguments.cases && !interrupted(); ++k) {
    print_report(questions(source, arguments.seed + static_cast<std::uint64_t>(k)));
  }
  return kExitNothingFound;
}

}  // namespace

Command add_generate(CLI::App& program) {
  const auto given = std::make_shared<GenerateArguments>();
  CLI::App& command =
      *program.add_subcommand("generate", "Print questions, one a line, for a program to answer");
  command.add_option("--family", given->family, "where rays come from: FAMILY or FAMILY@SEVERITY")
      ->required();
  command.add_option("--cases", given->cases, "how many cases")
      ->check(CLI::Range(1, 1000000000))
      ->capture_default_str();
  add_seed(command, given->seed);
  return {&command, [given] { return run_generate(*given); }};
}

}  // namespace raycheck::tools
