#include <limits>
#include <stdexcept>

#include "scene/number.h"
#include "tools/edge.h"
#include "tools/stress/stress.h"
#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

struct StressArguments : CommonArguments {
  StressOptions options;
  std::vector<std::string> methods;
  std::string severity;
};

/// "3" or "2..7"
std::pair<int, int> parse_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  const auto number = [&](const std::string& part) {
    const auto severity = scene::parse_integer(part);
    if (severity && *severity >= 0 && *severity <= std::numeric_limits<int>::max()) {
      return static_cast<int>(*severity);
    }
    throw std::invalid_argument("--severity " + text +
                                ": give a severity, or a range of severities, A..B");
  };
  if (dots == std::string::npos) return {number(text), number(text)};
  const std::pair<int, int> range = {number(text.substr(0, dots)), number(text.substr(dots + 2))};
  if (range.first > range.second) {
    throw std::invalid_argument("--severity " + text + ": give the lower severity first");
  }
  return range;
}

int run_stress(StressArguments& arguments) {
  if (!arguments.severity.empty()) arguments.options.severities = parse_range(arguments.severity);
  arguments.options.implementations = find_by_stages(arguments.methods, arguments.external);
  std::optional<OutputFile> certificates = opened("--certificates", arguments.certificates);
  std::optional<OutputFile> view = opened("--view", arguments.view);
  const std::unique_ptr<Units> units =
      units_of(arguments.shards, arguments.options.implementations);
  const StressReport report =
      run_stress(arguments.options, run_control("stress", arguments.threads), units.get());
  if (units && !units->are_all()) return shard_done(arguments.shards, *units, report.interrupted);
  if (certificates) certificates->write(stress_certificates(report));
  print_view(kStressViews, arguments.format, report);
  if (view) view->write(page(stress_document(report)));
  return exit_code(report.interrupted, !report.all_stable(), report.compared() > 0);
}

}  // namespace

CommandRun add_stress(CLI::App& command) {
  const auto given = std::make_shared<StressArguments>();
  StressOptions& options = given->options;
  command
      .add_option("--source,--family", options.families, "only these sources, separated by commas")
      ->delimiter(',');
  add_methods(command, given->methods);
  command.add_option(
      "--severity", given->severity,
      "only this severity, or this range, A..B (default: all severities of the source)");
  add_cases(command, options.cases, "the number of cases at each severity");
  add_seed(command, options.seed);
  add_external(command, given->external);
  add_threads(command, given->threads, "the report");
  add_shards(command, given->shards);
  add_view(command, given->view, "error against severity, for every source and quantile");
  add_certificates(command, given->certificates);
  add_format(command, given->format, names_of(kStressViews));
  return [given] { return run_stress(*given); };
}

}  // namespace raycheck::tools
