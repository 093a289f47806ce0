#include <algorithm>
#include <memory>
#include <stdexcept>

#include "tools/arguments.h"
#include "tools/commands.h"
#include "tools/gate_arguments.h"
#include "tools/properties/properties.h"
#include "tools/terminal.h"
#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

struct PropertiesArguments {
  std::string filter;
  int cases = properties::kCampaignCases;
  std::uint64_t seed = 1;
  std::string replay;
  std::string rays;
  std::vector<std::string> intersect;
  ExternalArguments external;
  std::string dialect;
  std::vector<std::string> sources;
  std::string level;
  std::optional<double> max_ulp;
  bool frontier = false;
  bool strict = false;
  std::optional<std::string> view;
  std::string format;
  GateArguments gate;
};

/// Domain: one of kLevelNames.
properties::Level level_called(const std::string& name) {
  const auto& names = properties::kLevelNames;
  return static_cast<properties::Level>(std::find(names.begin(), names.end(), name) -
                                        names.begin());
}

int run_properties_command(const PropertiesArguments& arguments) {
  if (!arguments.replay.empty() &&
      !(arguments.filter.empty() && arguments.sources.empty() && arguments.rays.empty() &&
        arguments.intersect.empty() && arguments.level.empty() && !arguments.frontier)) {
    throw std::invalid_argument(
        "--replay: names its law, methods and source; leave out --filter, --source, --level, "
        "--frontier, --rays, --intersect");
  }
  PropertiesOptions options;
  options.filter = arguments.filter;
  options.cases = arguments.cases;
  options.seed = arguments.seed;
  options.replay = arguments.replay;
  options.sources = arguments.sources;
  if (!arguments.level.empty()) options.level = level_called(arguments.level);
  options.max_error = arguments.max_ulp;
  options.frontier = arguments.frontier;
  options.strict = arguments.strict;
  const bool methods_asked = !(arguments.rays.empty() && arguments.intersect.empty());
  options.implementations = find_candidates(arguments.external, parse_driver(arguments.dialect));
  if (methods_asked) {
    const auto pairs = built_in(chosen_methods(arguments.rays, arguments.intersect));
    options.implementations.insert(options.implementations.begin(), pairs.begin(), pairs.end());
  }
  std::optional<OutputFile> view = opened("--view", arguments.view);
  GateFiles files(arguments.gate);
  PropertiesReport report = run_properties(options, run_control("laws"));
  report.ratchet = files.ratchet(properties_gate(report).findings, report.interrupted);
  files.write(kPropertiesViews, report);
  print_view(kPropertiesViews, arguments.format, report);
  if (view) {
    view->write(page(properties_document(report, run_control("page"))));
  }
  const bool fails = report.ratchet ? report.ratchet->fails() : report.failures() > 0;
  return exit_code(report.interrupted, fails, report.is_conclusive());
}

}  // namespace

CommandRun add_properties(CLI::App& command) {
  const auto given = std::make_shared<PropertiesArguments>();
  PropertiesArguments& arguments = *given;
  command.add_option("--filter", arguments.filter, "laws whose name contains this");
  command
      .add_option("--cases", arguments.cases,
                  "cases for each law and candidate, shared among sources and severities")
      ->check(whole_number(1, kMostCases))
      ->capture_default_str();
  add_seed(command, arguments.seed);
  command.add_option("--replay", arguments.replay, "the string that a failure printed");
  command.add_option("--rays", arguments.rays, "only this method of making rays");
  command.add_option("--intersect", arguments.intersect,
                     "only this intersection method; several "
                     "times for several");
  add_external(command, arguments.external);
  add_renderer(command, arguments.external);
  command.add_option("--dialect", arguments.dialect,
                     "of the driver files that renderers are given: A, B, C, 2017 to 2020, auto "
                     "(what it reads), or a form such as B:17:no-light (default: B)");
  command.add_option("--source", arguments.sources,
                     "only cases of this source, or of this severity (SOURCE@SEVERITY); several "
                     "times for several");
  command
      .add_option("--level", arguments.level,
                  "which severities of a source are asked: ordinary, demanding (those too) or "
                  "extreme (all); default: what the candidate states, else ordinary for someone "
                  "else's and demanding for raycheck's methods")
      ->check(CLI::IsMember(std::vector<std::string>(properties::kLevelNames.begin(),
                                                     properties::kLevelNames.end())));
  command.add_flag("--frontier", arguments.frontier,
                   "show beside direct/cross how far beyond the level each law holds; breaks none");
  add_strict(command, arguments.strict);
  add_view(command, arguments.view, "the shrunk case of every broken law");
  command
      .add_option("--max-ulp", arguments.max_ulp,
                  "the bound on every error (default: the method's documented bounds)")
      ->check(kBound);
  add_format(command, arguments.format, kPropertiesViews);
  add_gate(command, arguments.gate, kPropertiesViews);
  return [given] { return run_properties_command(*given); };
}

}  // namespace raycheck::tools
