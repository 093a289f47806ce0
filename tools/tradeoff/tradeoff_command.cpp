#include <memory>
#include <stdexcept>

#include "tools/arguments.h"
#include "tools/commands.h"
#include "tools/terminal.h"
#include "tools/tradeoff/tradeoff.h"
#include "tools/view/chart/chart.h"
#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

struct TradeoffArguments {
  TradeoffOptions options;
  std::vector<std::string> methods;
  std::string dialect;
  std::string plot;
  std::optional<std::string> view;
  std::string format;
  ExternalArguments external;
};

int run_tradeoff(TradeoffArguments& arguments) {
  TradeoffOptions& options = arguments.options;
  const int subjects = (options.scene.empty() ? 0 : 1) + (options.sources.empty() ? 0 : 1) +
                       (options.all_families ? 1 : 0);
  if (subjects > 1) {
    throw std::invalid_argument("tradeoff: give one of SCENE, --family and --all-families");
  }
  options.dialect = parse_dialect(arguments.dialect);
  if (!arguments.plot.empty()) require_plottable(arguments.plot);
  std::optional<OutputFile> view = opened("--view", arguments.view);
  options.implementations = find_by_stages(arguments.methods, arguments.external);
  const TradeoffReport report = run_tradeoff(options, run_control("tradeoff"));
  print_warnings(report.warnings);
  print_view(kTradeoffViews, arguments.format, report);
  if (!arguments.plot.empty() && !report.interrupted)
    draw_or_say(tradeoff_facets(report, false), arguments.plot);
  if (view) view->write(page(tradeoff_document(report)));
  return exit_code(report.interrupted, false, report.compared() > 0);
}

}  // namespace

CommandRun add_tradeoff(CLI::App& command) {
  const auto given = std::make_shared<TradeoffArguments>();
  TradeoffOptions& options = given->options;
  command.add_option("SCENE", options.scene,
                     "a scene: only what it needs is compared (default: ordinary cases)");
  add_dialect(command, given->dialect);
  command
      .add_option("--family", options.sources,
                  "cases of these families or other sources, separated by commas")
      ->delimiter(',');
  command.add_flag("--all-families", options.all_families, "cases of every family");
  add_methods(command, given->methods);
  command.add_option("--cases", options.cases, "how many cases, or pixels of a scene")
      ->check(whole_number(1, kMostCases))
      ->capture_default_str();
  add_seed(command, options.seed);
  command.add_option("--plot", given->plot,
                     "draw error against time to a file, .svg, .png or .pdf");
  add_view(command, given->view, "error against run time, every source, severity and quantile");
  add_external(command, given->external);
  add_format(command, given->format, kTradeoffViews);
  return [given] { return run_tradeoff(*given); };
}

}  // namespace raycheck::tools
