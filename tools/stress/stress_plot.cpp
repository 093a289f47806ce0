#include <fmt/core.h>

#include <algorithm>

#include "tools/report/words.h"
#include "tools/stress/stress_views.h"

namespace raycheck::tools {

using properties::Stage;
using properties::Tally;

namespace {

/// The methods of one stage that are judged in one format: their errors have one unit.
Plot plot_of(const FamilyReport& family, Stage stage, scene::Precision precision) {
  Plot plot;
  plot.title = fmt::format("{}: 99.9% error against severity ({}{})", family.family->name,
                           name(stage), precision_words(precision));
  plot.x_label = fmt::format("severity: {}", family.family->dial->meaning);
  plot.y_label =
      fmt::format("{}, in {} (infinite: {:g})", stage == Stage::kRays ? "angle of D" : "error of s",
                  unit_name(properties::main_quantity(stage), precision), kLargestPlotted);
  PlotSeries floor;
  floor.name = "99.9% kappa: what the problem itself magnifies";
  floor.style = PlotSeries::Style::kDashes;
  floor.colour = "#888888";
  for (const StressCurve& curve : family.curves) {
    if (curve.method.stage != stage || curve.method.precision() != precision) continue;
    PlotSeries series;
    series.name = std::string(curve.method.name());
    const bool first = floor.points.empty();
    for (std::size_t k = 0; k < curve.results.size(); ++k) {
      const Tally* const tally = curve.tally(k);
      if (tally == nullptr) continue;
      const double severity = curve.severities[k];
      const double error = tally->quantile(0.999).value_or(0);
      series.points.push_back(
          {severity, std::clamp(error, kSmallestPlotted, kLargestPlotted), 0, 0});
      if (first) {
        floor.points.push_back({severity,
                                std::clamp(tally->condition_quantile(0.999).value_or(0),
                                           kSmallestPlotted, kLargestPlotted),
                                0, 0});
      }
    }
    if (!series.points.empty()) plot.series.push_back(std::move(series));
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
