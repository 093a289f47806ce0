#include <fmt/core.h>

#include <algorithm>

#include "tools/stress/stress_views.h"

namespace raycheck::tools {

using properties::Stage;
using properties::Tally;

std::vector<Plot> stress_plots(const StressReport& report) {
  std::vector<Plot> plots;
  for (const FamilyReport& family : report.families) {
    for (const Stage stage : {Stage::kRays, Stage::kIntersection}) {
      Plot plot;
      plot.title =
          fmt::format("{}: 99.9% error against severity ({})", family.family->name, name(stage));
      plot.x_label = fmt::format("severity: {}", family.family->dial->meaning);
      plot.y_label = fmt::format("{} (infinite: {:g})",
                                 stage == Stage::kRays ? "angle of D, in u" : "error of s, in ulp",
                                 kLargestPlotted);
      PlotSeries floor;
      floor.name = "99.9% kappa: what the problem itself magnifies";
      floor.style = PlotSeries::Style::kDashes;
      floor.colour = "#888888";
      for (const StressCurve& curve : family.curves) {
        if (curve.method.stage != stage) continue;
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
      if (plot.series.empty()) continue;
      plot.series.insert(plot.series.begin(), std::move(floor));
      plots.push_back(std::move(plot));
    }
  }
  return plots;
}

}  // namespace raycheck::tools
