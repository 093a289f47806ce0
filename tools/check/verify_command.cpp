#include <memory>
#include <string>

#include "tools/arguments.h"
#include "tools/check/verify.h"
#include "tools/commands.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

/// More answers than these are for several runs, each with a --seed of its own.
constexpr std::size_t kMostBytes = std::size_t{1} << 27;

struct VerifyArguments {
  std::string family;
  VerifyOptions options;
  std::string format;
};

int run_verify(const VerifyArguments& arguments) {
  VerifyOptions options = arguments.options;
  options.source = parse_given_rays(arguments.family);
  const VerifyReport report = verify(read_in(kMostBytes), options, run_control("answers"));
  print_view(kVerifyViews, arguments.format, report);
  return exit_code(report.interrupted, !report.holds(), report.candidate.is_enough_judged());
}

}  // namespace

CommandRun add_verify(CLI::App& command) {
  const auto given = std::make_shared<VerifyArguments>();
  VerifyOptions& options = given->options;
  command
      .add_option("--family", given->family,
                  "as given to generate: exactly its questions must be answered")
      ->required();
  add_exchanged(command, options.cases, options.seed, options.precision);
  add_top(command, options.top);
  add_max_ulp(command, options.max_error,
              "errors above are discrepancies (default: the bounds of direct/cross)");
  add_strict(command, options.strict);
  add_format(command, given->format, kVerifyViews);
  return [given] { return run_verify(*given); };
}

}  // namespace raycheck::tools
