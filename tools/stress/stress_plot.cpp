#include <fmt/core.h>

#include <limits>

#include "tools/report/words.h"
#include "tools/stress/stress_views.h"

namespace raycheck::tools {

using properties::Stage;
using properties::Tally;

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The methods of one stage that are judged in one format: their errors have one unit.
Plot plot_of(const FamilyReport& family, Stage stage, scene::Precision precision) {
  Plot plot;
  plot.title = fmt::format("{}: 99.9% error against severity ({}{})", family.family->name,
                           name(stage), precision_words(precision));
  plot.x_label = fmt::format("severity: {}", family.family->dial->meaning);
  plot.y_label = fmt::format("99.9% {}, in {}",
                             stage == Stage::kRays ? "angle of the direction" : "error of s",
                             unit_name(properties::main_quantity(stage), precision));
  PlotSeries floor;
  floor.name = "kappa of the problem";
  floor.style = PlotSeries::Style::kDashes;
  for (const StressCurve& curve : family.curves) {
    if (curve.stage != stage) continue;
    PlotSeries series;
    series.name = curve.method.name;
    series.number = curve.method.number;
    if (curve.method.precision != precision) continue;
    bool is_measured = false;
    for (std::size_t k = 0; k < curve.results.size(); ++k) {
      const Tally* const tally = curve.tally(k);
      const auto error = tally == nullptr ? std::nullopt : tally->quantile(0.999);
      const double severity = curve.severities[k];
      series.points.push_back(
          {severity, error.value_or(kNoNumber), standing_of(curve.results[k].inside)});
      is_measured = is_measured || error;
      if (floor.points.size() > k) continue;
      const auto condition = tally == nullptr ? std::nullopt : tally->condition_quantile(0.999);
      floor.points.push_back({severity, condition.value_or(kNoNumber)});
    }
    if (is_measured) plot.series.push_back(std::move(series));
  }
  if (!plot.series.empty()) plot.series.insert(plot.series.begin(), std::move(floor));
  return plot;
}

}  // namespace

std::vector<Plot> stress_plots(const StressReport& report) {
  std::vector<Plot> plots;
  for (const FamilyReport& family : report.families) {
    for (const Stage stage : {Stage::kRays, Stage::kIntersection}) {
      for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
        Plot plot = plot_of(family, stage, precision);
        if (!plot.series.empty()) plots.push_back(std::move(plot));
      }
    }
  }
  return plots;
}

}  // namespace raycheck::tools
