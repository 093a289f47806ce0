#include "tools/report/plot/plot.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "tools/report/plot/plot_series.h"

namespace raycheck::tools {
namespace {

constexpr double kPlottedInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

PlotFrame frame() {
  return {100, 100, PlotAxis::even({0, 10}, 100), PlotAxis::powers({0.1, 1000}, 100, false)};
}

TEST(PlotSeries, NoTwoLookAlike) {
  std::set<std::string> looks;
  for (std::size_t k = 0; k < kPlotLooks; ++k) {
    const PlotSeries series{"", PlotSeries::Style::kCurve, {{1, 1}}, k};
    const std::string parts = series_parts(series, "$d")[1];  // the colour
    const std::string data = series_data(series, frame());    // the shape
    EXPECT_TRUE(looks.insert(parts + data).second) << k;
  }
}

TEST(PlotSeries, ShowsWhatDecisionsWere) {
  const auto data = [](PlotStanding standing) {
    return series_data({"", PlotSeries::Style::kCurve, {{0, 1, standing}}, 0}, frame());
  };
  const std::string y = data(PlotStanding::kRight).substr(5, 5);
  EXPECT_EQ(data(PlotStanding::kRight), "0.00 " + y + " 7 " + y + " NaN\n");
  EXPECT_EQ(data(PlotStanding::kExcused), "0.00 " + y + " 6 NaN NaN\n");
  EXPECT_EQ(data(PlotStanding::kDefect), "0.00 " + y + " 6 NaN " + y + "\n");
}

TEST(PlotSeries, BreaksWhereThereIsNoError) {
  const PlotSeries series{"", PlotSeries::Style::kCurve, {{0, 1}, {5, kNaN}, {10, 1}}, 0};
  EXPECT_TRUE(contains(series_data(series, frame()), "\n\n100.00 "));
}

/// Every method has its name in the picture, whatever is in it, and there is no legend to follow.
TEST(PlotScript, NamesSeriesDirectly) {
  Plot plot;
  plot.title = "it's";
  plot.series = {
      {"cross'; system 'x", PlotSeries::Style::kCurve, {{0, 1}, {1, kPlottedInfinity}}, 0},
      {"robust_{2}", PlotSeries::Style::kCurve, {{0, 0}, {1, kNaN}}, 1}};
  const std::string script = gnuplot_script({plot}, "a.svg");
  EXPECT_TRUE(contains(script, "set label 'cross''; system ''x' at ")) << script;
  EXPECT_TRUE(contains(script, "set label 'robust_{2}' at ")) << script;
  EXPECT_TRUE(contains(script, "unset key")) << script;
  EXPECT_TRUE(contains(script, "'infinite'")) << script;
  EXPECT_TRUE(contains(script, "set label 'it''s'")) << script;
}

}  // namespace
}  // namespace raycheck::tools
