#include "tools/worst/worst.h"

#include <fmt/core.h>

#include <boost/algorithm/string/replace.hpp>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace raycheck::tools {
namespace {

using properties::Quantity;
using properties::Stage;

/// The quantities that a stage measures, by their names with hyphens for spaces.
std::vector<std::pair<std::string, Quantity>> quantities_of(Stage stage) {
  std::vector<std::pair<std::string, Quantity>> quantities;
  for (std::size_t k = 0; k < properties::kQuantityCount; ++k) {
    const auto quantity = static_cast<Quantity>(k);
    if (properties::law_of(stage, quantity) == nullptr) continue;
    quantities.emplace_back(boost::replace_all_copy(std::string(info(quantity).name), " ", "-"),
                            quantity);
  }
  return quantities;
}

/// The last stage of the method, unless an earlier one measures the quantity.
Stage chosen_stage(const WorstOptions& options) {
  for (const Stage stage : options.method.stages) {
    for (const auto& [name, quantity] : quantities_of(stage)) {
      if (name == options.quantity) return stage;
    }
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
  std::string known;
  for (const auto& [name, quantity] : quantities_of(stage)) {
    if (name == chosen) return quantity;
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
  report.search = options.search;
  properties::SearchOptions& search = report.search;
  search.source = chosen_family(options.family);
  if (report.stage == Stage::kRays && !search.source.source->has_camera) {
    throw std::invalid_argument(fmt::format("family {}: has no camera, and {} makes rays",
                                            options.family, report.method.name));
  }
  search.quantity = chosen_quantity(options.quantity, report.stage);
  report.worst = properties::find_worst_case(counted(report.method.make(), report), report.stage,
                                             search, control);
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
