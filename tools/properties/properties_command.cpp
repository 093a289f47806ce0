#include <stdexcept>

#include "tools/edge.h"
#include "tools/properties/properties.h"
#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

struct PropertiesArguments : CommonArguments {
  PropertiesOptions options;
  std::vector<std::string> sources;
  GateArguments gate;
  std::string budget;
};

/// "90s", "10m" or "2h"
double seconds_of(const std::string& text) {
  const std::string number = text.substr(0, text.size() - 1);
  const double unit = text.ends_with('s') ? 1 : text.ends_with('m') ? 60 : 3600;
  const bool is_whole = !number.empty() && number.size() < 6 &&
                        number.find_first_not_of("0123456789") == std::string::npos;
  if (!is_whole || std::stoi(number) == 0 || (unit == 3600 && !text.ends_with('h'))) {
    throw std::invalid_argument("--for " + text + ": give a whole number and s, m or h: 90s, 10m");
  }
  return unit * std::stoi(number);
}

int run_properties_command(PropertiesArguments& arguments) {
  PropertiesOptions& options = arguments.options;
  std::ranges::transform(arguments.sources, std::back_inserter(options.sources), parse_source);
  options.implementations = find_judged(arguments);
  std::optional<OutputFile> view = opened("--view", arguments.view);
  GateFiles files(arguments.gate);
  if (!arguments.budget.empty()) {
    options.cases = cases_for(options, seconds_of(arguments.budget),
                              run_control("number of cases", arguments.threads));
  }
  const std::unique_ptr<Units> units = units_of(arguments.shards, options.implementations);
  PropertiesReport report =
      run_properties(options, run_control("laws", arguments.threads), units.get());
  if (units && !units->are_all()) return shard_done(arguments.shards, *units, report.interrupted);
  report.time = arguments.budget;
  const Gate gate = files.compared(report, properties_gate);
  files.write(kPropertiesViews, report, gate);
  print_view(kPropertiesViews, arguments.gate.format, report, gate);
  if (view) view->write(page(properties_document(report, run_control("page"))));
  const bool fails = report.ratchet ? report.ratchet->fails() : !report.holds();
  return exit_code(report.interrupted, fails, report.is_conclusive());
}

}  // namespace

CommandRun add_properties(CLI::App& command) {
  const auto given = std::make_shared<PropertiesArguments>();
  PropertiesOptions& options = given->options;
  command.add_option("--filter", options.filters,
                     "only laws whose name contains this; may be repeated");
  add_cases(command, options.cases,
            "cases for each law, candidate and level, shared among sources and severities");
  add_seed(command, options.seed);
  CLI::Option* const replay =
      command.add_option("--replay", options.replay, "the string that a failure printed");
  command.add_option("--rays", given->rays, "only this method of making rays");
  command.add_option("--intersect", given->intersect,
                     "only this intersection method; may be repeated");
  add_judged(command, given->external);
  command.add_option("--dialect", given->dialect,
                     "the format of driver files for renderers: A, B, C, 2017 to 2020, auto (what "
                     "the renderer reads), or a form such as B:17:no-light (default: B)");
  command.add_option("--source", given->sources,
                     "only cases of this source, or of this severity (SOURCE@SEVERITY); may be "
                     "repeated");
  add_named(
      command, "--level", options.level, properties::kLevelNames,
      "the hardest cases that are tried, besides those of a --source with a severity: ordinary, "
      "demanding or extreme (default: what the candidate declares, else demanding for raycheck's "
      "methods that keep all their bounds, and ordinary for all others)");
  // A replay string already determines law, methods and source.
  add_shards(command, given->shards);
  for (const char* other : {"--filter", "--source", "--level", "--rays", "--intersect", "--out"}) {
    replay->excludes(command.get_option(other));
  }
  command
      .add_option("--for", given->budget,
                  "try cases for this time on this machine, 90s, 10m or 2h; the report gives their "
                  "number")
      ->type_name("TIME")
      ->excludes(replay, command.get_option("--cases"), command.get_option("--out"));
  add_named(command, "--target", options.target, properties::kClimbNames,
            "after the random cases, hill-climb from the worst of them to maximise a value of each "
            "law; error: its error; bound: the error divided by the factor by which its bound "
            "grows with the condition number; rho: the stability ratio")
      ->excludes(replay);
  command
      .add_option("--corpus", options.corpus,
                  "first try the cases in this folder; then add to it the shrunk cases that break "
                  "a law; commit it")
      ->type_name("FOLDER")
      ->excludes(replay);
  command
      .add_option("--keep-going", options.keep_going,
                  "shrink up to this number of a law's failures that differ in source or kind, not "
                  "only the first")
      ->check(whole_number(1, 1000))
      ->type_name("N");
  add_strict(command, options.strict);
  add_threads(command, given->threads, "the report");
  add_view(command, given->view, "the shrunk case of every broken law");
  add_max_ulp(command, options.max_error,
              "errors above this are discrepancies (default: the documented bounds)");
  add_gate(command, given->gate, names_of(kPropertiesViews));
  return [given] { return run_properties_command(*given); };
}

}  // namespace raycheck::tools
