#include <iostream>
#include <memory>
#include <stdexcept>

#include "tools/arguments.h"
#include "tools/command_line.h"
#include "tools/commands.h"
#include "tools/exchange/exchange.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

struct GenerateArguments {
  std::string family;
  int cases = 100;
  std::uint64_t seed = 1;
};

int generate(const GenerateArguments& arguments) {
  properties::ChosenSource source;
  try {
    source = properties::chosen_source(arguments.family);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("--family " + arguments.family + ": " + error.what() +
                                "; `raycheck list` shows the sources");
  }
  if (source.source->has_camera) {
    throw std::invalid_argument("--family " + arguments.family +
                                ": its cases have cameras, which one line does not hold");
  }
  catch_interrupts();
  for (int k = 0; k < arguments.cases && !interrupted(); ++k) {
    print_report(questions(source, arguments.seed + static_cast<std::uint64_t>(k)));
  }
  return kExitNothingFound;
}

struct VerifyArguments {
  std::size_t top = 10;
  std::uint64_t cases = 0;
  std::optional<double> max_ulp;
  std::string format = "text";
};

int verify_answers(const VerifyArguments& arguments) {
  VerifyReport report = verify(std::cin, arguments.max_ulp, arguments.top);
  report.cases_asked = arguments.cases;
  print_report(arguments.format == "json" ? verify_json(report)
                                          : verify_text(report, stdout_takes_colours()));
  return exit_code(false, !report.candidate.verdict.holds() || is_short(report),
                   report.candidate.verdict.compared() > 0);
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
  return {&command, [given] { return generate(*given); }};
}

Command add_verify(CLI::App& program) {
  const auto given = std::make_shared<VerifyArguments>();
  CLI::App& command = *program.add_subcommand(
      "verify", "Judge a program's answers to the questions of generate, from standard input");
  command.add_option("--cases", given->cases,
                     "how many cases generate was asked for; fewer that are answered are failures");
  command.add_option("--top", given->top, "how many of the worst discrepancies are shown")
      ->check(CLI::Range(std::size_t{0}, properties::kKeptDiscrepancies))
      ->capture_default_str();
  command
      .add_option("--max-ulp", given->max_ulp,
                  "errors above are discrepancies (default: the bounds of direct/cross)")
      ->check(kBound);
  add_format(command, given->format, {"text", "json"});
  return {&command, [given] { return verify_answers(*given); }};
}

}  // namespace raycheck::tools
