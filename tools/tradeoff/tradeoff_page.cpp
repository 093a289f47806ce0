#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "tools/tradeoff/tradeoff.h"

namespace raycheck::tools {

std::vector<std::size_t> pareto_front(const std::vector<std::pair<double, double>>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> front;
  for (const std::size_t k : order) {
    if (front.empty() || points[k].second < points[front.back()].second) front.push_back(k);
  }
  return front;
}

namespace {

using properties::Stage;

/// The time in batches; if batches could not be timed, the time of single calls.
std::optional<ChartTime> chart_time(const MethodCost& cost, const MethodCost* baseline) {
  const auto& time = cost.batch ? cost.batch : cost.scalar;
  if (!time || baseline == nullptr) return std::nullopt;
  const double base = baseline->batch->median;
  return ChartTime{time->median / base, time->low / base, time->high / base, time->median};
}

/// Marks the Pareto front of the points that `point_of` finds in each series, for each quantity and
/// share.
template <class PointOf>
void mark_front(ChartFacet& facet, PointOf point_of) {
  for (std::size_t quantity = 0; quantity < facet.quantities.size(); ++quantity) {
    for (std::size_t share = 0; share < kChartShares.size(); ++share) {
      std::vector<std::pair<double, double>> places;
      std::vector<ChartPoint*> points;
      for (ChartSeries& series : facet.series) {
        std::optional<ChartPoint>& point = point_of(series);
        if (!series.time || !point || point->defects > 0) continue;
        const auto& error = point->errors[quantity].at[share];
        if (!error) continue;
        places.emplace_back(series.time->ratio, *error);
        points.push_back(&*point);
      }
      for (const std::size_t k : pareto_front(places)) {
        points[k]->errors[quantity].is_front[share] = true;
      }
    }
  }
}

void mark_fronts(ChartFacet& facet) {
  mark_front(
      facet, [](ChartSeries & one) -> auto& { return one.whole; });
  for (std::size_t k = 0; k < facet.severities.size(); ++k) {
    mark_front(
        facet, [k](ChartSeries & one) -> auto& { return one.points[k]; });
  }
}

/// "3", or "126..188", for the k-th stretch of a source.
std::string stretch_text(const JudgedSource& source, std::size_t k) {
  const int first = source.severities[k];
  const int last = k + 1 < source.severities.size() ? source.severities[k + 1] - 1 : source.last;
  return first == last ? std::to_string(first) : fmt::format("{}..{}", first, last);
}

/// The candidates of one stage and format, on one source of the report or on all sources.
struct Part {
  const TradeoffReport& report;
  const std::vector<MethodCost>& costs;
  Stage stage;
  scene::Precision precision;
};

/// The series of a facet, with the data that `fill` adds. Series without comparisons are left out.
template <class Fill>
void add_series(const Part& part, ChartFacet& facet, Fill fill) {
  const MethodCost* const base = baseline(part.costs);
  if (base != nullptr) facet.baseline = base->candidate.name;
  for (const MethodCost& cost : part.costs) {
    if (cost.promises.precision != part.precision) continue;
    ChartSeries series{.name = cost.candidate.name,
                       .number = cost.candidate.number,
                       .time = chart_time(cost, base),
                       .note = cost.not_timed};
    fill(cost, series);
    if (series.whole) facet.series.push_back(std::move(series));
  }
  mark_fronts(facet);
}

ChartFacet empty_facet(const Part& part, std::string subject) {
  return {.subject = std::move(subject),
          .stage = chart_stage(part.stage, part.precision),
          .quantities = chart_quantities(part.stage),
          .precision = part.precision};
}

ChartFacet facet_of_all(const Part& part) {
  ChartFacet facet = empty_facet(part, subject_text(part.report));
  add_series(part, facet, [&](const MethodCost& cost, ChartSeries& series) {
    series.whole = chart_point(cost.accuracy.inside.tallies(), facet.quantities);
  });
  return facet;
}

ChartFacet facet_of_source(const Part& part, std::size_t index) {
  const JudgedSource& source = part.report.sources[index];
  ChartFacet facet = empty_facet(part, source.name);
  facet.meaning = source.meaning;
  const bool has_stretches = source.severities.size() > 1;
  for (std::size_t k = 0; has_stretches && k < source.severities.size(); ++k) {
    facet.severities.push_back(stretch_text(source, k));
  }
  add_series(part, facet, [&](const MethodCost& cost, ChartSeries& series) {
    Tallies all;
    for (const Tallies& tallies : cost.by_severity[index]) {
      for (const auto& [quantity, tally] : tallies) all[quantity].merge(tally);
      if (has_stretches) series.points.push_back(chart_point(tallies, facet.quantities));
    }
    series.whole = chart_point(all, facet.quantities);
  });
  return facet;
}

/// A report's facets for all of its sources together, and for each source.
std::vector<ChartFacet> facets_of(const TradeoffReport& report) {
  std::vector<ChartFacet> facets;
  const auto add = [&](ChartFacet facet) {
    if (!facet.series.empty()) facets.push_back(std::move(facet));
  };
  for (const auto& [stage, costs] : {std::pair(Stage::kIntersection, &report.intersections),
                                     std::pair(Stage::kRays, &report.rays)}) {
    for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
      if (!has_any(*costs, precision)) continue;
      const Part part{report, *costs, stage, precision};
      if (report.sources.size() > 1) add(facet_of_all(part));
      for (std::size_t k = 0; k < report.sources.size(); ++k) add(facet_of_source(part, k));
    }
  }
  return facets;
}

}  // namespace

ViewDocument tradeoff_document(const TradeoffReport& report) {
  ViewDocument document;
  document.title = fmt::format("Error against run time: {}", subject_text(report));
  document.left_out = report.left_out;
  document.chart = ChartView{facets_of(report)};
  return document;
}

}  // namespace raycheck::tools
