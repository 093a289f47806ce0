#include <algorithm>
#include <limits>
#include <memory>

#include "tools/arguments.h"
#include "tools/commands.h"
#include "tools/plan/plan.h"

namespace raycheck::tools {
namespace {

struct PlanArguments {
  PlanOptions options;
  std::string dialect;
  std::string wanted = "nearest";
  std::string format;
};

int run_plan(PlanArguments& arguments) {
  arguments.options.dialect = parse_dialect(arguments.dialect);
  arguments.options.wanted = static_cast<scene::Wanted>(
      std::find(scene::kWantedNames.begin(), scene::kWantedNames.end(), arguments.wanted) -
      scene::kWantedNames.begin());
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
  command
      .add_option("--wanted", arguments.wanted,
                  "class: of every sphere; nearest: the nearest sphere; parameter: with its s; "
                  "point: with s and Q")
      ->check(CLI::IsMember(
          std::vector<std::string>(scene::kWantedNames.begin(), scene::kWantedNames.end())))
      ->capture_default_str();
  command.add_option("--top", arguments.options.top, "how many spheres the text shows")
      ->check(whole_number(0, std::numeric_limits<int>::max()))
      ->capture_default_str();
  command.add_option("--dialect", arguments.dialect,
                     "of a driver file: A, B or C, or a year, 2017 to 2020");
  add_format(command, arguments.format, kPlanViews);
  return [given] { return run_plan(*given); };
}

}  // namespace raycheck::tools
