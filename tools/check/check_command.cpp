#include <tbb/info.h>

#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/arguments.h"
#include "tools/check/check.h"
#include "tools/commands.h"
#include "tools/gate_arguments.h"
#include "tools/terminal.h"
#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

struct CheckArguments {
  std::string scene;
  std::string dialect;
  std::string rays;
  std::vector<std::string> intersect;
  ExternalArguments external;
  bool all = false;
  std::string pixels = "all";
  std::size_t top = 10;
  std::optional<double> max_ulp;
  bool strict = false;
  std::optional<std::string> certificates;
  std::optional<std::string> view;
  int threads = tbb::info::default_concurrency();
  std::string format;
  GateArguments gate;
};

int run_check(const CheckArguments& arguments) {
  CheckOptions options;
  options.path = arguments.scene;
  const std::optional<DriverRule> rule = parse_driver(arguments.dialect);
  options.keeps_forms = rule.has_value();
  if (rule && !rule->tries_others) options.dialect = rule->form.dialect;
  if (arguments.all && !(arguments.rays.empty() && arguments.intersect.empty() &&
                         arguments.external.candidates.empty())) {
    throw std::invalid_argument(
        "--all: judges every method; leave out --rays, --intersect and --candidate");
  }
  const bool methods_asked = !(arguments.rays.empty() && arguments.intersect.empty());
  options.implementations = find_candidates(arguments.external, rule);
  if (arguments.all) {
    options.implementations = built_in(all_pairs());
  } else if (methods_asked || options.implementations.empty()) {
    const auto pairs = built_in(chosen_methods(arguments.rays, arguments.intersect));
    options.implementations.insert(options.implementations.begin(), pairs.begin(), pairs.end());
  }
  if (arguments.pixels != "all") options.pixels = parse_index("--pixels", arguments.pixels, 1);
  options.top = arguments.top;
  options.max_error = arguments.max_ulp;
  options.strict = arguments.strict;
  std::optional<OutputFile> certificates = opened("--certificates", arguments.certificates);
  std::optional<OutputFile> view = opened("--view", arguments.view);
  GateFiles files(arguments.gate);
  CheckReport report = check(options, run_control(options.path, arguments.threads));
  report.ratchet = files.ratchet(check_gate(report).findings, report.interrupted);
  print_warnings(report.warnings);
  files.write(kCheckViews, report);
  if (certificates) certificates->write(check_certificates(report));
  print_view(kCheckViews, arguments.format, report, arguments.gate.picture_link);
  if (view) {
    view->write(
        page(check_document(report, {{}, methods_asked}, run_control("page", arguments.threads))));
  }
  const bool fails = report.ratchet ? report.ratchet->fails() : !report.holds();
  return exit_code(report.interrupted, fails, report.is_enough_judged());
}

}  // namespace

CommandRun add_check(CLI::App& command) {
  const auto given = std::make_shared<CheckArguments>();
  CheckArguments& arguments = *given;
  command.add_option("SCENE", arguments.scene, "a TOML scene, or a driver file of the course")
      ->required();
  command.add_option("--dialect", arguments.dialect,
                     "of a driver file: A, B or C; where a candidate is a renderer, of the files "
                     "that it is given: also 2017 to 2020, auto (what it reads), or a form such as "
                     "B:17:no-light (default: the scene's own, else B)");
  command.add_option("--rays", arguments.rays, "the method that makes rays (default: direct)");
  command.add_option("--intersect", arguments.intersect,
                     "the method that intersects them, several times for several (default: cross)");
  add_external(command, arguments.external);
  add_renderer(command, arguments.external);
  command.add_flag("--all", arguments.all, "every pair of methods");
  command.add_option("--pixels", arguments.pixels, "all, or how many, spread evenly")
      ->capture_default_str();
  command.add_option("--top", arguments.top, "how many of the worst discrepancies are shown")
      ->check(whole_number(0, properties::kKeptDiscrepancies))
      ->capture_default_str();
  command
      .add_option("--max-ulp", arguments.max_ulp,
                  "errors above are discrepancies (default: the method's documented bound)")
      ->check(kBound);
  add_strict(command, arguments.strict);
  add_threads(command, arguments.threads, "the report");
  add_certificates(command, arguments.certificates);
  add_view(command, arguments.view, "the scene and its worst discrepancies");
  add_format(command, arguments.format, kCheckViews);
  add_gate(command, arguments.gate, kCheckViews);
  return [given] { return run_check(*given); };
}

}  // namespace raycheck::tools
