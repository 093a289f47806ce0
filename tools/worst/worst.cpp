#include "tools/worst/worst.h"

#include <fmt/core.h>

#include <boost/algorithm/string/replace.hpp>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "properties/cases/random.h"
#include "scene/invalid_input.h"
#include "tools/shards/run_units.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;
using properties::Random;
using properties::Stage;

/// The quantities that a stage measures, with their names (hyphens for spaces).
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

/// The last stage of the candidate, unless an earlier one measures the quantity.
Stage chosen_stage(const WorstOptions& options) {
  for (const Stage stage : options.candidate.stages) {
    for (const auto& [name, quantity] : quantities_of(stage)) {
      if (name == options.quantity) return stage;
    }
  }
  return options.candidate.stages.back();
}

Quantity chosen_quantity(const std::string& chosen, Stage stage) {
  if (chosen.empty()) return properties::main_quantity(stage);
  std::string known;
  for (const auto& [name, quantity] : quantities_of(stage)) {
    if (name == chosen) return quantity;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw scene::InvalidInput(
      "quantity", chosen,
      fmt::format("no such quantity of {}; give one of {}", name(stage), known));
}

template <class Answer, class... Arguments>
void count_failures(std::function<Answer(Arguments...)>& function, WorstFound& found) {
  if (!function) return;
  function = [asked = function, &found](Arguments... arguments) -> Answer {
    try {
      return asked(arguments...);
    } catch (const std::runtime_error& error) {
      if (found.failures++ == 0) found.first_failure = error.what();
      throw;
    }
  };
}

properties::Candidate counted(properties::Candidate candidate, WorstFound& found) {
  count_failures(candidate.frame, found);
  count_failures(candidate.pixel_points, found);
  count_failures(candidate.pixel_rays, found);
  count_failures(candidate.focal_rays, found);
  count_failures(candidate.intersect, found);
  return candidate;
}

}  // namespace

bool WorstReport::is_unstable() const {
  return worst && worst->stability.outcome == properties::Outcome::kUnstable;
}

void WorstFound::merge(WorstFound later) {
  if (failures == 0) first_failure = std::move(later.first_failure);
  failures += later.failures;
  if (!later.worst || (worst && worst->height >= later.worst->height)) return;
  worst = std::move(later.worst);
}

WorstReport find_worst(const WorstOptions& options, const properties::RunControl& control,
                       Units* units) {
  WorstReport report;
  report.candidate = options.candidate;
  report.stage = chosen_stage(options);
  report.search = options.search;
  properties::SearchOptions& search = report.search;
  if (report.stage == Stage::kRays && !report.source().source->has_camera) {
    throw scene::InvalidInput(
        "source", report.source().name(),
        fmt::format("has no camera, and {} makes rays", report.candidate.name));
  }
  search.quantity = chosen_quantity(options.quantity, report.stage);
  report.searches = options.searches;
  std::int64_t done = 0;
  run_units<WorstFound>(
      options.searches, units, control,
      [&](std::int64_t k) {
        properties::SearchOptions its = search;
        if (k > 0) its.seed = Random(search.seed + static_cast<std::uint64_t>(k)).bits();
        WorstFound found;
        found.worst = properties::find_worst_case(
            counted(in_random_cases(report.candidate.make()), found), report.stage, its, control);
        return found;
      },
      [&](WorstFound& found) {
        report.merge(std::move(found));
        control.progress(fmt::format("{} of {} searches", ++done, options.searches));
      });
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
