#include <iostream>
#include <memory>

#include "tools/arguments.h"
#include "tools/commands.h"
#include "tools/exchange/verify_views.h"

namespace raycheck::tools {
namespace {

struct VerifyArguments {
  VerifyOptions options;
  std::string format;
};

int run_verify(const VerifyArguments& arguments) {
  const VerifyReport report = verify(std::cin, arguments.options);
  print_view(kVerifyViews, arguments.format, report);
  return exit_code(false, !report.holds(), report.candidate.is_enough_judged());
}

}  // namespace

Command add_verify(CLI::App& program) {
  const auto given = std::make_shared<VerifyArguments>();
  VerifyOptions& options = given->options;
  CLI::App& command = *program.add_subcommand(
      "verify", "Judge a program's answers to the questions of generate, from standard input");
  command.add_option("--cases", options.cases,
                     "how many cases generate was asked for; fewer that are answered are failures");
  command.add_option("--top", options.top, "how many of the worst discrepancies are shown")
      ->check(CLI::Range(std::size_t{0}, properties::kKeptDiscrepancies))
      ->capture_default_str();
  command
      .add_option("--max-ulp", options.max_error,
                  "errors above are discrepancies (default: the bounds of direct/cross)")
      ->check(kBound);
  add_strict(command, options.strict);
  add_format(command, given->format, kVerifyViews);
  return {&command, [given] { return run_verify(*given); }};
}

}  // namespace raycheck::tools
