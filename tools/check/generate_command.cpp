#include <memory>
#include <string>

#include "tools/arguments.h"
#include "tools/check/generate.h"
#include "tools/commands.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

/// Questions are printed in pieces of at least this many bytes.
constexpr std::size_t kPrintedAtATime = 1 << 16;

struct GenerateArguments {
  std::string family;
  std::uint64_t cases = 0;
  std::uint64_t seed = 0;
  scene::Precision precision = scene::Precision::kDouble;
};

int run_generate(const GenerateArguments& arguments) {
  const properties::ChosenSource source = parse_given_rays(arguments.family);
  std::string text;
  for (std::uint64_t k = 0; k < arguments.cases && !interrupted(); ++k) {
    text += question_lines(source, arguments.seed + k, arguments.precision);
    if (text.size() < kPrintedAtATime) continue;
    print_report(text);
    text.clear();
  }
  print_report(text);
  return exit_code(interrupted(), false, true);
}

}  // namespace

CommandRun add_generate(CLI::App& command) {
  const auto given = std::make_shared<GenerateArguments>();
  command.add_option("--family", given->family, "where rays come from: FAMILY or FAMILY@SEVERITY")
      ->required();
  add_exchanged(command, given->cases, given->seed, given->precision);
  return [given] { return run_generate(*given); };
}

}  // namespace raycheck::tools
