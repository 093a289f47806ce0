#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "properties/search/campaign.h"
#include "properties/search/worst_case.h"
#include "scene/number.h"
#include "tools/arguments.h"
#include "tools/command_line.h"
#include "tools/commands.h"
#include "tools/report/json.h"
#include "tools/report/words.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;
using properties::Stage;
using properties::WorstCase;

struct Arguments {
  std::string method;
  std::string family;
  std::string quantity;
  std::string climb = "error";
  properties::SearchOptions options;
  std::string save;
  std::string format = "text";
};

StagedMethod chosen_method(const std::string& name) {
  const std::vector<StagedMethod> methods = find_methods({name});
  if (methods.size() > 1) {
    throw std::invalid_argument(
        fmt::format("--method {0}: there are two; give rays/{0} or intersect/{0}", name));
  }
  return methods.front();
}

Quantity chosen_quantity(const std::string& given, Stage stage) {
  if (given.empty()) return properties::main_quantity(stage);
  std::string known;
  for (std::size_t k = 0; k < properties::kQuantityCount; ++k) {
    const auto quantity = static_cast<Quantity>(k);
    if (properties::law_of(stage, quantity) == nullptr) continue;
    std::string name(info(quantity).name);
    std::replace(name.begin(), name.end(), ' ', '-');
    if (name == given) return quantity;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument(fmt::format("--quantity {}: no such quantity of {}; there are {}",
                                          given, name(stage), known));
}

/// Fills in the options that are names; throws std::invalid_argument naming the wrong one.
StagedMethod resolve(Arguments& arguments) {
  const StagedMethod method = chosen_method(arguments.method);
  properties::SearchOptions& options = arguments.options;
  try {
    options.source = properties::chosen_source(arguments.family);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("--family " + arguments.family + ": " + error.what() +
                                "; see raycheck list");
  }
  if (method.stage == Stage::kRays && !options.source.source->has_camera) {
    throw std::invalid_argument(fmt::format("--family {}: has no camera, and {} makes rays",
                                            arguments.family, method.name()));
  }
  options.quantity = chosen_quantity(arguments.quantity, method.stage);
  const auto* const climb =
      std::find(properties::kClimbNames.begin(), properties::kClimbNames.end(), arguments.climb);
  options.climb = static_cast<properties::Climb>(climb - properties::kClimbNames.begin());
  return method;
}

std::string headline(const WorstCase& worst, const StagedMethod& method,
                     const properties::SearchOptions& options) {
  return fmt::format("{} {} on {}: off by {} {}, condition number {}, rho {}: {}", method.name(),
                     info(options.quantity).name, options.source.name(), error_text(worst.error),
                     info(options.quantity).unit, error_text(worst.stability.condition),
                     error_text(worst.stability.ratio), name(worst.stability.outcome));
}

/// The numbers of a case, to the bit.
std::string in_hexfloat(const scene::Scene& scene) {
  std::string text;
  const auto add = [&](const char* name, std::initializer_list<double> numbers) {
    text += fmt::format("  {:<9}", name);
    for (const double x : numbers) text += " " + scene::hexfloat(x);
    text += "\n";
  };
  if (scene.camera) {
    const scene::Camera& c = *scene.camera;
    add("eye", {c.eye.x, c.eye.y, c.eye.z});
    add("look_at", {c.look_at.x, c.look_at.y, c.look_at.z});
    add("up", {c.up.x, c.up.y, c.up.z});
    add("near", {c.near});
    add("bounds", {c.left, c.right, c.bottom, c.top});
  }
  for (const scene::Ray& ray : scene.rays) {
    add("origin", {ray.origin.x, ray.origin.y, ray.origin.z});
    add("direction", {ray.direction.x, ray.direction.y, ray.direction.z});
  }
  for (const scene::Sphere& sphere : scene.spheres) {
    add("centre", {sphere.centre.x, sphere.centre.y, sphere.centre.z});
    add("radius", {sphere.radius});
  }
  return text;
}

std::string text_of(const WorstCase& worst, const StagedMethod& method,
                    const properties::SearchOptions& options) {
  std::string text = headline(worst, method, options) + "\n";
  text += fmt::format("climbed on {}: {} by random cases, {} by climbing, {} when shrunk\n",
                      properties::kClimbNames[static_cast<std::size_t>(options.climb)],
                      error_text(worst.height_random), error_text(worst.height_climbed),
                      error_text(worst.height));
  text += fmt::format("  got   {}\n  exact {}\n\n", numbers_text(worst.shown.got),
                      numbers_text(worst.shown.exact));
  return text + in_hexfloat(worst.the_case.scene) + "\n" + properties::text(worst.the_case);
}

std::string json_of(const WorstCase& worst, const StagedMethod& method,
                    const properties::SearchOptions& options) {
  Json json = json_header("worst");
  json["method"] = method.name();
  json["family"] = options.source.name();
  json["seed"] = options.seed;
  json["climbed_on"] = properties::kClimbNames[static_cast<std::size_t>(options.climb)];
  json["random"] = error_json(worst.height_random);
  json["climbed"] = error_json(worst.height_climbed);
  json["shrunk"] = error_json(worst.height);
  json["error"] = error_json(worst.error);
  json["unit"] = info(options.quantity).unit;
  json["condition"] = error_json(worst.stability.condition);
  json["ratio"] = error_json(worst.stability.ratio);
  json["outcome"] = name(worst.stability.outcome);
  json["discrepancy"] = discrepancy_json(worst.shown);
  json["scene"] = properties::text(worst.the_case);
  return json.dump(2) + "\n";
}

int run(Arguments& arguments) {
  const StagedMethod method = resolve(arguments);
  const auto worst = properties::find_worst_case(candidate_of(method), method.stage,
                                                 arguments.options, run_control("worst"));
  if (!worst) {
    print_report(fmt::format("{} on {}: nothing was measured in its stated domain\n", method.name(),
                             arguments.family));
    return exit_code(interrupted(), false, false);
  }
  print_report(arguments.format == "json" ? json_of(*worst, method, arguments.options)
                                          : text_of(*worst, method, arguments.options));
  if (!arguments.save.empty()) {
    std::ofstream file(arguments.save);
    file << properties::text(worst->the_case, headline(*worst, method, arguments.options));
    if (!file.flush()) {
      throw std::runtime_error("--save " + arguments.save + ": could not be written");
    }
  }
  const bool unstable = worst->stability.outcome == properties::Outcome::kUnstable;
  return exit_code(interrupted(), unstable, true);
}

}  // namespace

Command add_worst(CLI::App& program) {
  const auto given = std::make_shared<Arguments>();
  properties::SearchOptions& options = given->options;
  CLI::App& command = *program.add_subcommand(
      "worst", "Search for the input on which a method's certified error is worst");
  command.add_option("--method", given->method, "the method, of either kind")->required();
  command
      .add_option("--family", given->family,
                  "the family or other source to start from, or FAMILY@SEVERITY")
      ->required();
  command.add_option("--quantity", given->quantity,
                     "direction or pixel-point; parameter, backward-error or hit-point (default: "
                     "direction or parameter)");
  command
      .add_option("--by", given->climb,
                  "what to climb on: the error, the error over what the documented bound grows by, "
                  "or the stability ratio rho")
      ->check(CLI::IsMember(
          std::vector<std::string>(properties::kClimbNames.begin(), properties::kClimbNames.end())))
      ->capture_default_str();
  command.add_option("--cases", options.cases, "random cases")
      ->check(CLI::Range(1, 1000000000))
      ->capture_default_str();
  command.add_option("--steps", options.steps, "changes tried after the random cases")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  add_seed(command, options.seed);
  command.add_option("--save", given->save, "write the input to a TOML scene");
  add_format(command, given->format, {"text", "json"});
  return {&command, [given] { return run(*given); }};
}

}  // namespace raycheck::tools
