#include "tools/worst/worst.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace raycheck::tools {
namespace {

using properties::Quantity;
using properties::Stage;

StagedMethod chosen_method(const std::string& name) {
  const std::vector<StagedMethod> methods = find_methods({name});
  if (methods.size() > 1) {
    throw std::invalid_argument(
        fmt::format("method {0}: there are two; give rays/{0} or intersect/{0}", name));
  }
  return methods.front();
}

properties::ChosenSource chosen_family(const std::string& name) {
  try {
    return properties::chosen_source(name);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("family " + name + ": " + error.what() +
                                "; `raycheck list` shows the sources");
  }
}

Quantity chosen_quantity(const std::string& chosen, Stage stage) {
  if (chosen.empty()) return properties::main_quantity(stage);
  std::string known;
  for (std::size_t k = 0; k < properties::kQuantityCount; ++k) {
    const auto quantity = static_cast<Quantity>(k);
    if (properties::law_of(stage, quantity) == nullptr) continue;
    std::string name(info(quantity).name);
    std::replace(name.begin(), name.end(), ' ', '-');
    if (name == chosen) return quantity;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument(
      fmt::format("quantity {}: no such quantity of {}; there are {}", chosen, name(stage), known));
}

properties::Climb chosen_climb(const std::string& name) {
  const auto* const found =
      std::find(properties::kClimbNames.begin(), properties::kClimbNames.end(), name);
  if (found == properties::kClimbNames.end()) {
    throw std::invalid_argument("climb " + name + ": no such height to climb on");
  }
  return static_cast<properties::Climb>(found - properties::kClimbNames.begin());
}

}  // namespace

bool WorstReport::is_unstable() const {
  return worst && worst->stability.outcome == properties::Outcome::kUnstable;
}

WorstReport find_worst(const WorstOptions& options, const properties::RunControl& control) {
  WorstReport report;
  report.method = chosen_method(options.method);
  properties::SearchOptions& search = report.search;
  search.source = chosen_family(options.family);
  if (report.method.stage == Stage::kRays && !search.source.source->has_camera) {
    throw std::invalid_argument(fmt::format("family {}: has no camera, and {} makes rays",
                                            options.family, report.method.name()));
  }
  search.quantity = chosen_quantity(options.quantity, report.method.stage);
  search.climb = chosen_climb(options.climb);
  search.cases = options.cases;
  search.steps = options.steps;
  search.seed = options.seed;
  report.worst = properties::find_worst_case(candidate_of(report.method), report.method.stage,
                                             search, control);
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
