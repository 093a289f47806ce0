#include "properties/verdict.h"
#include "tools/check/check.h"
#include "tools/edge.h"
#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

struct CheckArguments : CommonArguments {
  CheckOptions options;
  bool all = false;
  std::string pixels = "all";
  GateArguments gate;
};

int run_check(CheckArguments& arguments) {
  CheckOptions& options = arguments.options;
  options.keeps_forms = !arguments.dialect.empty();
  options.read_as = parse_dialect(arguments.dialect);
  options.implementations = arguments.all ? built_in(all_pairs()) : find_judged(arguments);
  if (options.implementations.empty()) options.implementations = {built_in(kDefaultMethods)};
  if (arguments.pixels != "all") {
    options.pixels = parse_index("--pixels", arguments.pixels, 1, kMostIndex, "all, or ");
  }
  std::optional<OutputFile> certificates = opened("--certificates", arguments.certificates);
  std::optional<OutputFile> view = opened("--view", arguments.view);
  GateFiles files(arguments.gate);
  const std::unique_ptr<Units> units = units_of(arguments.shards, options.implementations);
  CheckReport report = check(options, run_control(options.path, arguments.threads), units.get());
  if (units && !units->are_all()) return shard_done(arguments.shards, *units, report.interrupted);
  const Gate gate = files.compared(report, check_gate);
  print_warnings(report.warnings);
  files.write(kCheckViews, report, gate);
  if (certificates) certificates->write(check_certificates(report));
  print_view(kCheckViews, arguments.gate.format, report, gate);
  if (view) {
    const CheckPageOptions shown = {{}, !arguments.rays.empty() || !arguments.intersect.empty()};
    view->write(page(check_document(report, shown, run_control("page", arguments.threads))));
  }
  const bool fails = report.ratchet ? report.ratchet->fails() : !report.holds();
  return exit_code(report.interrupted, fails, report.is_enough_judged());
}

}  // namespace

CommandRun add_check(CLI::App& command) {
  const auto given = std::make_shared<CheckArguments>();
  CheckArguments& arguments = *given;
  command
      .add_option("SCENE", arguments.options.path, "a TOML scene, or a driver file of the course")
      ->required();
  command.add_option("--dialect", arguments.dialect,
                     "the format of driver files: A, B or C, the year of a course (2017 to 2020), "
                     "auto (what the renderer reads), a form such as B:17:no-light, another format "
                     "such as nff, or a file FORMAT.toml (default: the scene's own, else B)");
  CLI::Option* const rays =
      command.add_option("--rays", arguments.rays, "the method that makes rays (default: direct)");
  CLI::Option* const intersect =
      command.add_option("--intersect", arguments.intersect,
                         "the method that intersects rays; may be repeated (default: "
                         "cross)");
  add_judged(command, arguments.external);
  command.add_flag("--all", arguments.all, "every pair of methods")
      ->excludes(rays, intersect, command.get_option("--candidate"));
  command.add_option("--pixels", arguments.pixels, "all, or a number of pixels, spread evenly")
      ->capture_default_str();
  add_number(command, "--top", arguments.options.top, 0, properties::kKeptDiscrepancies,
             "the number of worst discrepancies to show");
  add_max_ulp(command, arguments.options.max_error,
              "errors above this are discrepancies (default: the documented bounds)");
  add_strict(command, arguments.options.strict);
  add_threads(command, arguments.threads, "the report");
  add_shards(command, arguments.shards);
  add_certificates(command, arguments.certificates);
  add_view(command, arguments.view, "the scene and its worst discrepancies");
  add_gate(command, arguments.gate, names_of(kCheckViews));
  return [given] { return run_check(*given); };
}

}  // namespace raycheck::tools
