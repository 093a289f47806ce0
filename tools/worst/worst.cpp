#include "tools/worst/worst.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

namespace raycheck::tools {
namespace {

using properties::Quantity;
using properties::Stage;

/// The quantity of this name that a stage measures, with hyphens for spaces.
std::optional<Quantity> quantity_of(Stage stage, const std::string& chosen) {
  for (std::size_t k = 0; k < properties::kQuantityCount; ++k) {
    const auto quantity = static_cast<Quantity>(k);
    if (properties::law_of(stage, quantity) == nullptr) continue;
    std::string name(info(quantity).name);
    std::replace(name.begin(), name.end(), ' ', '-');
    if (name == chosen) return quantity;
  }
  return std::nullopt;
}

Stage chosen_stage(const WorstOptions& options) {
  for (const Stage stage : options.method.stages) {
    if (quantity_of(stage, options.quantity)) return stage;
  }
  return options.method.stages.back();
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
  if (const auto quantity = quantity_of(stage, chosen)) return *quantity;
  std::string known;
  for (std::size_t k = 0; k < properties::kQuantityCount; ++k) {
    const auto quantity = static_cast<Quantity>(k);
    if (properties::law_of(stage, quantity) == nullptr) continue;
    std::string name(info(quantity).name);
    std::replace(name.begin(), name.end(), ' ', '-');
    known += (known.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument(
      fmt::format("quantity {}: no such quantity of {}; there are {}", chosen, name(stage), known));
}

/// Counts how many times a function fails.
template <class Answer, class... Arguments>
void count_failures(std::function<Answer(Arguments...)>& function, WorstReport& report) {
  if (!function) return;
  function = [asked = function, &report](Arguments... arguments) -> Answer {
    try {
      return asked(arguments...);
    } catch (const std::runtime_error& error) {
      if (report.failures++ == 0) report.first_failure = error.what();
      throw;
    }
  };
}

properties::Candidate counted(properties::Candidate candidate, WorstReport& report) {
  count_failures(candidate.frame, report);
  count_failures(candidate.pixel_points, report);
  count_failures(candidate.pixel_rays, report);
  count_failures(candidate.focal_rays, report);
  count_failures(candidate.intersect, report);
  return candidate;
}

}  // namespace

bool WorstReport::is_unstable() const {
  return worst && worst->stability.outcome == properties::Outcome::kUnstable;
}

WorstReport find_worst(const WorstOptions& options, const properties::RunControl& control) {
  WorstReport report;
  report.method = options.method;
  report.stage = chosen_stage(options);
  properties::SearchOptions& search = report.search;
  search.source = chosen_family(options.family);
  if (report.stage == Stage::kRays && !search.source.source->has_camera) {
    throw std::invalid_argument(fmt::format("family {}: has no camera, and {} makes rays",
                                            options.family, report.method.name));
  }
  search.quantity = chosen_quantity(options.quantity, report.stage);
  search.climb = options.climb;
  search.cases = options.cases;
  search.steps = options.steps;
  search.seed = options.seed;
  report.worst = properties::find_worst_case(counted(report.method.make(), report), report.stage,
                                             search, control);
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
