#include "tools/report/plot/plot_series.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace raycheck::tools {
namespace {

/// Okabe and Ito's colours (Color Universal Design, 2008), which most colour-blind readers tell
/// apart, but for yellow, which white paper swallows.
constexpr std::array<std::string_view, 7> kColours = {"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                                      "#56b4e9", "#d55e00", "#000000"};
/// gnuplot's point types: filled, and the same open.
struct Shape {
  int filled, open;
};
constexpr std::array<Shape, 6> kShapes = {
    {{kFilledCircle, kOpenCircle}, {5, 4}, {9, 8}, {13, 12}, {11, 10}, {15, 14}}};
constexpr std::array<std::string_view, 5> kDashes = {"solid", "(9,4)", "(2,3)", "(9,3,2,3)",
                                                     "(5,3,2,3,2,3)"};
static_assert(kColours.size() * kShapes.size() == kPlotLooks);

Shape shape_of(const PlotSeries& series) { return kShapes[series.number % kShapes.size()]; }

}  // namespace

/// 6 shapes and 7 colours in turn: no two numbers below 42 have both.
std::string_view series_colour(const PlotSeries& series) {
  return kColours[series.number % kColours.size()];
}

std::string series_data(const PlotSeries& series, const PlotFrame& frame) {
  std::string text;
  for (const PlotPoint& point : series.points) {
    if (std::isnan(point.y)) {
      text += "\n";
      continue;
    }
    // x, y, the mark, y again where it has an outline and where it is crossed, from where to where.
    const std::string y = fmt::format("{:.2f}", frame.y.place(point.y));
    const bool is_right = point.standing == PlotStanding::kRight;
    const bool is_defect = point.standing == PlotStanding::kDefect;
    text += fmt::format("{:.2f} {} {} {} {}", frame.x.place(point.x), y,
                        is_right ? shape_of(series).filled : shape_of(series).open,
                        is_right ? y : "NaN", is_defect ? y : "NaN");
    if (series.style == PlotSeries::Style::kPoint) {
      text +=
          fmt::format(" {:.2f} {:.2f}", frame.x.place(point.x_low), frame.x.place(point.x_high));
    }
    text += "\n";
  }
  return text;
}

std::vector<std::string> series_parts(const PlotSeries& series, const std::string& block) {
  const std::string colour = fmt::format("lc rgb '{}'", series_colour(series));
  const double size = series.style == PlotSeries::Style::kPoint ? 1.3 : 0.8;
  std::vector<std::string> parts;
  switch (series.style) {
    case PlotSeries::Style::kDashes:
      return {fmt::format("{} using 1:2 with lines lc rgb '{}' lw 1.5 dt (8,6)", block, kPlotGrey)};
    case PlotSeries::Style::kSteps:
      return {fmt::format("{} using 1:2 with steps lc rgb '{}' lw 2 dt 3", block, kPlotGrey)};
    case PlotSeries::Style::kPoint:
      parts.push_back(
          fmt::format("{} using 1:2:6:7 with xerrorbars pt 0 {} lw 1.5", block, colour));
      break;
    case PlotSeries::Style::kCurve:
      parts.push_back(fmt::format("{} using 1:2 with lines {} lw 1.8 dt {}", block, colour,
                                  kDashes[series.number % kDashes.size()]));
      break;
  }
  parts.push_back(
      fmt::format("{} using 1:2:3 with points pt variable ps {} {} lw 2", block, size, colour));
  parts.push_back(fmt::format("{} using 1:4 with points pt {} ps {} lc rgb '#333333' lw 0.7", block,
                              shape_of(series).open, size));
  parts.push_back(fmt::format("{} using 1:5 with points pt {} ps {} lc rgb '{}' lw 1.8", block,
                              kPlotCross, size, kPlotDefects));
  return parts;
}

}  // namespace raycheck::tools
