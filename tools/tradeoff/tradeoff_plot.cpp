#include <fmt/core.h>

#include <utility>

#include "tools/report/words.h"
#include "tools/tradeoff/tradeoff_front.h"
#include "tools/tradeoff/tradeoff_views.h"

namespace raycheck::tools {
namespace {

using properties::Stage;
using properties::Tally;

/// The methods that are judged in one format: their errors have one unit.
Plot plot_of(const std::vector<MethodCost>& costs, Stage stage, scene::Precision precision,
             const std::string& subject) {
  Plot plot;
  const MethodCost* const base = baseline(costs);
  if (base == nullptr) return plot;
  plot.title = fmt::format("{}{}: error against run time on {}", name(stage),
                           precision_words(precision), subject);
  plot.x_label = fmt::format("run time in a batch, over that of {} ({:.3g} ns an item)",
                             base->method.name, base->batch->median);
  plot.y_label = fmt::format("99.9% {}, in {}",
                             stage == Stage::kRays ? "angle of the direction" : "error of s",
                             unit_name(properties::main_quantity(stage), precision));
  plot.log_x = true;
  plot.may_cut = true;
  plot.steps_mean = "Pareto front of those without defects";
  std::vector<std::pair<double, double>> places;  // of those without defects
  for (const MethodCost& cost : costs) {
    const Tally* const tally = cost.main();
    const auto& time = cost.batch ? cost.batch : cost.scalar;
    if (cost.promises.precision != precision || !time) continue;
    if (tally == nullptr || tally->errors.empty()) continue;
    const double unit = base->batch->median;
    const PlotPoint point{time->median / unit, *tally->quantile(0.999),
                          standing_of(cost.accuracy.inside), time->low / unit, time->high / unit};
    plot.series.push_back(
        {cost.method.name, PlotSeries::Style::kPoint, {point}, cost.method.number});
    if (point.standing != PlotStanding::kDefect) places.emplace_back(point.x, point.y);
  }
  if (plot.series.empty()) return plot;
  PlotSeries front;
  front.style = PlotSeries::Style::kSteps;
  for (const std::size_t k : pareto_front(places)) {
    front.points.push_back({places[k].first, places[k].second});
  }
  plot.series.insert(plot.series.begin(), std::move(front));
  return plot;
}

}  // namespace

std::vector<Plot> tradeoff_plots(const TradeoffReport& report) {
  std::vector<Plot> plots;
  for (const auto& [stage, costs] : {std::pair(Stage::kRays, &report.rays),
                                     std::pair(Stage::kIntersection, &report.intersections)}) {
    for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
      Plot plot = plot_of(*costs, stage, precision, subject_text(report));
      if (!plot.series.empty()) plots.push_back(std::move(plot));
    }
  }
  return plots;
}

}  // namespace raycheck::tools
