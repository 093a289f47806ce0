#pragma once

// Errors of methods against their run time, or against severity, as data.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "properties/stage.h"
#include "properties/tally.h"
#include "properties/verdict.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// The shares of errors that a chart has quantiles for; at the last they are the largest.
struct ChartShare {
  double share;
  std::string_view name;
};
inline constexpr std::array<ChartShare, 5> kChartShares = {
    {{0.5, "median"}, {0.9, "90%"}, {0.99, "99%"}, {0.999, "99.9%"}, {1, "largest"}}};
/// The one that reports compare methods by, and a chart shows first.
inline constexpr std::size_t kChartShare = 3;

/// Errors at each of kChartShares; empty where none was measured.
using ChartQuantiles = std::array<std::optional<double>, kChartShares.size()>;

/// What was judged of one method.
struct ChartPoint {
  struct Errors {
    std::uint64_t compared = 0;
    ChartQuantiles at = {};
    ChartQuantiles condition = {};  ///< Of the problem: what it magnifies errors by.
    /// Whether the method is on the front of those without defects, at each of the shares.
    std::array<bool, kChartShares.size()> is_front = {};
  };
  std::vector<Errors> errors;  ///< One of each quantity of the facet.
  std::uint64_t decisions = 0, wrong = 0, defects = 0;
};

/// What a method costs, over what the facet's baseline costs in the same run.
struct ChartTime {
  double ratio = 1, low = 1, high = 1;  ///< The median, and where the middle half lies.
  double nanoseconds = 0;               ///< The median, an item.
};

struct ChartSeries {
  std::string name = {};
  std::size_t number = 0;  ///< Of the method among all of the chart: what tells its mark.
  std::optional<ChartTime> time = {};
  std::string note = {};                 ///< Of its time, where something is to be said.
  std::optional<ChartPoint> whole = {};  ///< Of all severities together.
  std::vector<std::optional<ChartPoint>> points = {};  ///< One a severity.
};

/// Methods of one stage and format on the same inputs: their errors have the same units.
struct ChartFacet {
  std::string subject = {};                  ///< "distance", or the scene.
  std::string stage = {};                    ///< "Intersections", "Rays, in single precision"
  std::string meaning = {};                  ///< Of the severities.
  std::vector<std::string> severities = {};  ///< "3", or "128..191" where several are one.
  std::string baseline = {};  ///< The method that times are over; empty: there are none.
  std::vector<properties::Quantity> quantities = {};
  scene::Precision precision = scene::Precision::kDouble;
  std::vector<ChartSeries> series = {};
};

struct ChartView {
  std::vector<ChartFacet> facets;
  std::size_t share = kChartShare;  ///< Which of kChartShares is shown first.
};

/// What is judged of a stage and has errors: what reports compare methods by comes first.
std::vector<properties::Quantity> chart_quantities(properties::Stage stage);

/// "Intersections", "Rays, in single precision"
std::string chart_stage(properties::Stage stage, scene::Precision precision);

/// "Intersections on distance"
std::string chart_title(const ChartFacet& facet);
/// "run time, times that of quadratic", "severity: ...": what lies below a facet.
std::string chart_under(const ChartFacet& facet);
/// "parameter error", "backward error"
std::string chart_error(properties::Quantity quantity);

/// What tallies say, of those quantities; empty where nothing was compared.
std::optional<ChartPoint> chart_point(
    const std::map<properties::Quantity, properties::Tally>& tallies,
    const std::vector<properties::Quantity>& quantities);

/// What the page's script draws a chart of.
Json chart_json(const ChartView& chart);

/// Throws std::invalid_argument unless a plot may be drawn to that file: its name ends in .svg,
/// .png or .pdf, and its folder exists.
void require_plottable(const std::string& path);

/// There is no gnuplot to draw with.
class GnuplotMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Draws facets below one another into one file: the errors of their first quantity at
/// kChartShare, against the run time or the severity.
/// Errors: GnuplotMissing; std::runtime_error with gnuplot's message where it fails.
void draw(const std::vector<ChartFacet>& facets, const std::string& path);

/// What gnuplot is told.
std::string gnuplot_script(const std::vector<ChartFacet>& facets, const std::string& path);

}  // namespace raycheck::tools
