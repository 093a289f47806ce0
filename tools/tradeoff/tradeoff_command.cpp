#include "tools/edge.h"
#include "tools/tradeoff/tradeoff.h"
#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

struct TradeoffArguments : CommonArguments {
  TradeoffOptions options;
  std::vector<std::string> sources = {"rays", "cameras"};
  std::vector<std::string> methods;
};

int run_tradeoff(TradeoffArguments& arguments) {
  TradeoffOptions& options = arguments.options;
  options.read_as = parse_dialect(arguments.dialect);
  std::ranges::transform(arguments.sources, std::back_inserter(options.sources), parse_source);
  std::optional<OutputFile> view = opened("--view", arguments.view);
  options.implementations = find_by_stages(arguments.methods, arguments.external);
  const TradeoffReport report = run_tradeoff(options, run_control("tradeoff"));
  print_warnings(report.warnings);
  print_view(kTradeoffViews, arguments.format, report);
  if (view) view->write(page(tradeoff_document(report)));
  return exit_code(report.interrupted, false, report.compared() > 0);
}

}  // namespace

CommandRun add_tradeoff(CLI::App& command) {
  const auto given = std::make_shared<TradeoffArguments>();
  TradeoffOptions& options = given->options;
  CLI::Option* const scene = command.add_option(
      "SCENE", options.scene,
      "a scene, in place of random cases; only the stages that it needs are compared");
  add_dialect(command, given->dialect);
  CLI::Option* const family =
      command
          .add_option(
              "--source,--family", given->sources,
              "the sources of the random cases, separated by commas (default: rays,cameras)")
          ->delimiter(',')
          ->excludes(scene);
  command
      .add_flag("--all-families", options.all_families, "cases of every source that has severities")
      ->excludes(scene, family);
  add_methods(command, given->methods);
  add_cases(command, options.cases, "the number of cases, or of pixels of a scene");
  add_seed(command, options.seed);
  add_view(command, given->view, "error against run time, for every source, severity and quantile");
  add_external(command, given->external);
  add_format(command, given->format, names_of(kTradeoffViews));
  return [given] { return run_tradeoff(*given); };
}

}  // namespace raycheck::tools
