#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tools/report/words.h"
#include "tools/tradeoff/tradeoff_views.h"

namespace raycheck::tools {
namespace {

using properties::Stage;
using properties::Tally;

// gnuplot's point types.
constexpr int kFilledCircle = 7;
constexpr int kOpenTriangle = 8;
constexpr int kCross = 2;

/// Filled: every decision right; triangle: wrong ones, all excused; cross: defects.
int mark_of(const MethodCost& cost) {
  if (properties::defects(cost.accuracy.inside) > 0) return kCross;
  for (const auto& [quantity, tally] : cost.accuracy.inside.tallies()) {
    if (tally.wrong_answers() > 0) return kOpenTriangle;
  }
  return kFilledCircle;
}

/// The methods that are judged in one format: their errors have one unit.
Plot plot_of(const std::vector<MethodCost>& costs, Stage stage, scene::Precision precision,
             const std::string& subject) {
  Plot plot;
  const std::size_t sources =
      static_cast<std::size_t>(std::count(subject.begin(), subject.end(), ',')) + 1;
  plot.title =
      fmt::format("{}{}: error against time on {}", name(stage), precision_words(precision),
                  sources > 3 ? fmt::format("{} families", sources) : subject);
  plot.x_label = "ns per item in a batch";
  plot.y_label = fmt::format("99.9% {}, in {}",
                             stage == Stage::kRays ? "angle of the direction" : "error of s",
                             unit_name(properties::main_quantity(stage), precision));
  plot.log_x = true;
  PlotSeries front;
  front.name = "Pareto front, no defects";
  front.style = PlotSeries::Style::kSteps;
  front.colour = "#888888";
  std::vector<PlotSeries> methods;
  for (const MethodCost& cost : costs) {
    if (cost.promises.precision != precision) continue;
    const Tally* const tally = cost.main();
    const auto& time = cost.batch ? cost.batch : cost.scalar;
    if (tally == nullptr || tally->errors.empty() || !time) continue;
    const double error = *tally->quantile(0.999);
    const PlotPoint point{time->median, std::clamp(error, kSmallestPlotted, kLargestPlotted),
                          time->low, time->high};
    PlotSeries series;
    series.name = std::string(cost.method.name());
    series.style = PlotSeries::Style::kPointsWithSpread;
    series.mark = mark_of(cost);
    series.points = {point};
    methods.push_back(std::move(series));
    if (mark_of(cost) != kCross) front.points.push_back(point);
  }
  std::sort(front.points.begin(), front.points.end(),
            [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
  double least = std::numeric_limits<double>::infinity();
  std::erase_if(front.points, [&](const PlotPoint& point) {
    const bool beaten = point.y >= least;
    least = std::min(least, point.y);
    return beaten;
  });
  plot.series.push_back(std::move(front));
  std::move(methods.begin(), methods.end(), std::back_inserter(plot.series));
  // What the marks mean, drawn nowhere.
  const std::pair<int, const char*> marks[] = {
      {kFilledCircle, "all right"}, {kOpenTriangle, "wrong, excused"}, {kCross, "wrong: defects"}};
  for (const auto& [mark, meaning] : marks) {
    PlotSeries legend;
    legend.name = meaning;
    legend.style = PlotSeries::Style::kPoints;
    legend.mark = mark;
    legend.colour = "#444444";
    plot.series.push_back(std::move(legend));
  }
  return plot;
}

}  // namespace

std::vector<Plot> tradeoff_plots(const TradeoffReport& report) {
  std::vector<Plot> plots;
  for (const auto& [stage, costs] : {std::pair(Stage::kRays, &report.rays),
                                     std::pair(Stage::kIntersection, &report.intersections)}) {
    for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
      if (has_any(*costs, precision)) {
        plots.push_back(plot_of(*costs, stage, precision, report.subject));
      }
    }
  }
  return plots;
}

}  // namespace raycheck::tools
