#pragma once

// The data of charts: errors of candidates against their run time, or against severity.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/quantity.h"
#include "properties/tally.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// The quantiles of errors that a chart has; the last is the maximum.
struct ChartShare {
  double share;
  std::string_view name;
};
inline constexpr std::array<ChartShare, 5> kChartShares = {
    {{0.5, "median"}, {0.9, "90%"}, {0.99, "99%"}, {0.999, "99.9%"}, {1, "largest"}}};
/// The quantile by which reports compare candidates, and which a chart shows first.
inline constexpr std::size_t kChartShare = 3;

/// The error at each of kChartShares; empty if not measured.
using ChartQuantiles = std::array<std::optional<double>, kChartShares.size()>;

/// The results of one candidate.
struct ChartPoint {
  struct Errors {
    std::uint64_t compared = 0;
    ChartQuantiles at = {};
    ChartQuantiles condition = {};  ///< Quantiles of the condition number.
    /// For each share, whether it is on the Pareto front of the candidates without defects.
    std::array<bool, kChartShares.size()> is_front = {};
  };
  std::vector<Errors> errors;  ///< One for each quantity of the facet.
  std::uint64_t decisions = 0, wrong = 0, defects = 0;
};

/// A candidate's run time divided by that of the facet's baseline in the same run.
struct ChartTime {
  double ratio = 1, low = 1, high = 1;  ///< The median and the quartiles.
  double nanoseconds = 0;               ///< The median, per item.
};

struct ChartSeries {
  std::string name = {};
  std::size_t number = 0;  ///< Its index in the chart, which determines its mark.
  std::optional<ChartTime> time = {};
  std::string note = {};                               ///< A remark on its time, if any.
  std::optional<ChartPoint> whole = {};                ///< The results of all severities together.
  std::vector<std::optional<ChartPoint>> points = {};  ///< One per severity.
};

/// Candidates of one stage and format on the same inputs, so that their errors have the same units.
struct ChartFacet {
  std::string subject = {};  ///< "distance", or the scene.
  std::string stage = {};    ///< "Intersections", "Rays, in single precision"
  std::string meaning = {};  ///< The meaning of the severities.
  /// "3", or "128..191" if several are reported together.
  std::vector<std::string> severities = {};
  /// The candidate to which times are relative; empty if there are no times.
  std::string baseline = {};
  std::vector<properties::Quantity> quantities = {};
  scene::Precision precision = scene::Precision::kDouble;
  std::vector<ChartSeries> series = {};
};

struct ChartView {
  std::vector<ChartFacet> facets;
  std::size_t share = kChartShare;  ///< The index of the share in kChartShares that is shown first.
};

/// The quantities of a stage that have errors. The first is the one by which reports compare
/// candidates.
std::vector<properties::Quantity> chart_quantities(properties::Stage stage);

/// "Intersections", "Rays, in single precision"
std::string chart_stage(properties::Stage stage, scene::Precision precision);

/// The point for the tallies of these quantities; empty if nothing was compared.
std::optional<ChartPoint> chart_point(
    const std::map<properties::Quantity, properties::Tally>& tallies,
    const std::vector<properties::Quantity>& quantities);

/// The data from which the script of the page draws a chart.
Json chart_json(const ChartView& chart);

}  // namespace raycheck::tools
