#include <fmt/core.h>

#include <stdexcept>

#include "scene/invalid_input.h"
#include "tools/edge.h"
#include "tools/view/page/page.h"
#include "tools/worst/worst.h"

namespace raycheck::tools {
namespace {

struct WorstArguments : CommonArguments {
  WorstOptions options;
  std::string method, source;
  std::optional<std::string> save;
};

Implementation chosen_method(const WorstArguments& arguments) {
  if (arguments.method.empty()) return find_by_stages(arguments.external).front();
  const std::vector<Implementation> methods = find_methods({arguments.method});
  if (methods.size() > 1) {
    throw scene::InvalidInput(
        "method", arguments.method,
        fmt::format("is the name of two methods; give rays/{0} or intersect/{0}",
                    arguments.method));
  }
  return methods.front();
}

int run_worst(WorstArguments& arguments) {
  if (arguments.method.empty() && arguments.external.candidates.empty()) {
    throw std::invalid_argument("worst: give --method or --candidate");
  }
  if (arguments.external.candidates.size() > 1) {
    throw std::invalid_argument("--candidate: worst takes only one");
  }
  arguments.options.candidate = chosen_method(arguments);
  arguments.options.search.sources = {parse_source(arguments.source)};
  std::optional<OutputFile> scene = opened("--save", arguments.save);
  std::optional<OutputFile> view = opened("--view", arguments.view);
  const std::unique_ptr<Units> units =
      units_of(arguments.shards, {&arguments.options.candidate, 1});
  const WorstReport report =
      find_worst(arguments.options, run_control("worst", arguments.threads), units.get());
  if (units && !units->are_all()) return shard_done(arguments.shards, *units, report.interrupted);
  if (scene && report.worst) scene->write(worst_scene(report));
  print_view(kWorstViews, arguments.format, report);
  if (view && report.worst) {
    view->write(page(worst_document(report, run_control("page"))));
  }
  return exit_code(report.interrupted, report.is_unstable() || report.failures > 0,
                   report.worst.has_value());
}

}  // namespace

CommandRun add_worst(CLI::App& command) {
  const auto given = std::make_shared<WorstArguments>();
  WorstOptions& options = given->options;
  CLI::Option* const method = command.add_option("--method", given->method,
                                                 "the method that makes rays or intersects them");
  command
      .add_option("--source,--family", given->source,
                  "the source to start from, or SOURCE@SEVERITY")
      ->required();
  command.add_option(
      "--quantity", options.quantity,
      "for rays: direction (the default) or pixel-point; for intersections: parameter (the "
      "default), backward-error or hit-point");
  add_named(
      command, "--by", options.search.climb, properties::kClimbNames,
      "what to maximise: the error; the error divided by the growth of the documented bound with "
      "the condition number; or the stability ratio rho");
  add_cases(command, options.search.cases, "the number of random cases to start from");
  add_number(command, "--steps", options.search.steps, 0, kMostCases,
             "the number of changes tried after the random cases");
  add_seed(command, options.search.seed);
  add_number(command, "--searches", options.searches, 1, kMostCases,
             "the number of searches, each one from other random cases");
  add_threads(command, given->threads, "the report");
  add_shards(command, given->shards);
  command.add_option("--save", given->save, "write the input to a TOML scene");
  add_view(command, given->view, "the input");
  add_external(command, given->external);
  command.get_option("--candidate")->excludes(method);
  add_format(command, given->format, names_of(kWorstViews));
  return [given] { return run_worst(*given); };
}

}  // namespace raycheck::tools
