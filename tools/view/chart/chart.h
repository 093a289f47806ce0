#pragma once

// The data of charts: errors of methods against their run time, or against severity.

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

/// The shares of errors whose quantiles a chart has; the last one is the maximum.
struct ChartShare {
  double share;
  std::string_view name;
};
inline constexpr std::array<ChartShare, 5> kChartShares = {
    {{0.5, "median"}, {0.9, "90%"}, {0.99, "99%"}, {0.999, "99.9%"}, {1, "largest"}}};
/// The one by which reports compare methods, and which a chart shows first.
inline constexpr std::size_t kChartShare = 3;

/// Errors at each of kChartShares; empty if not measured.
using ChartQuantiles = std::array<std::optional<double>, kChartShares.size()>;

/// The results of one method.
struct ChartPoint {
  struct Errors {
    std::uint64_t compared = 0;
    ChartQuantiles at = {};
    ChartQuantiles condition = {};  ///< The factor by which the problem magnifies errors.
    /// Whether the method is on the front of those without defects, for each share.
    std::array<bool, kChartShares.size()> is_front = {};
  };
  std::vector<Errors> errors;  ///< One for each quantity of the facet.
  std::uint64_t decisions = 0, wrong = 0, defects = 0;
};

/// A method's run time over that of the facet's baseline in the same run.
struct ChartTime {
  double ratio = 1, low = 1, high = 1;  ///< The median, and the range of the middle half.
  double nanoseconds = 0;               ///< The median, per item.
};

struct ChartSeries {
  std::string name = {};
  std::size_t number = 0;  ///< The method's index in the chart: determines its mark.
  std::optional<ChartTime> time = {};
  std::string note = {};                               ///< A remark on its time, if any.
  std::optional<ChartPoint> whole = {};                ///< Of all severities together.
  std::vector<std::optional<ChartPoint>> points = {};  ///< One per severity.
};

/// Methods of one stage and format on the same inputs: their errors have the same units.
struct ChartFacet {
  std::string subject = {};                  ///< "distance", or the scene.
  std::string stage = {};                    ///< "Intersections", "Rays, in single precision"
  std::string meaning = {};                  ///< Of the severities.
  std::vector<std::string> severities = {};  ///< "3", or "128..191" where several are one.
  std::string baseline = {};                 ///< The method that times refer to; empty: no times.
  std::vector<properties::Quantity> quantities = {};
  scene::Precision precision = scene::Precision::kDouble;
  std::vector<ChartSeries> series = {};
};

struct ChartView {
  std::vector<ChartFacet> facets;
  std::size_t share = kChartShare;  ///< Which of kChartShares is shown first.
};

/// A stage's quantities with errors; the one that reports compare methods by is first.
std::vector<properties::Quantity> chart_quantities(properties::Stage stage);

/// "Intersections", "Rays, in single precision"
std::string chart_stage(properties::Stage stage, scene::Precision precision);

/// The tallies of these quantities; empty if nothing was compared.
std::optional<ChartPoint> chart_point(
    const std::map<properties::Quantity, properties::Tally>& tallies,
    const std::vector<properties::Quantity>& quantities);

/// The data from which the page's script draws a chart.
Json chart_json(const ChartView& chart);

}  // namespace raycheck::tools
