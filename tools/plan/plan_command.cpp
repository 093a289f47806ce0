#include <limits>

#include "tools/edge.h"
#include "tools/plan/plan.h"

namespace raycheck::tools {
namespace {

struct PlanArguments : CommonArguments {
  PlanOptions options;
};

int run_plan(PlanArguments& arguments) {
  arguments.options.read_as = parse_dialect(arguments.dialect);
  const PlanReport report = make_plan(arguments.options, run_control(arguments.options.path));
  print_warnings(report.warnings);
  print_view(kPlanViews, arguments.format, report);
  return exit_code(report.interrupted, false, true);
}

}  // namespace

CommandRun add_plan(CLI::App& command) {
  const auto given = std::make_shared<PlanArguments>();
  PlanArguments& arguments = *given;
  command.add_option("SCENE", arguments.options.path, "a scene with a camera")->required();
  add_named(command, "--wanted", arguments.options.wanted, scene::kWantedNames,
            "what is wanted; class: hit or miss for every sphere; nearest: the nearest sphere; "
            "parameter: the nearest sphere and its s; point: the nearest sphere, its s and Q");
  add_number(command, "--top", arguments.options.top, 0, std::numeric_limits<int>::max(),
             "the number of spheres in the text report");
  add_dialect(command, arguments.dialect);
  add_format(command, arguments.format, names_of(kPlanViews));
  return [given] { return run_plan(*given); };
}

}  // namespace raycheck::tools
