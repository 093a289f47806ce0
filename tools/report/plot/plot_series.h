#pragma once

// How gnuplot is told to draw a series. Internal to tools/report/plot/.

#include <string>
#include <string_view>
#include <vector>

#include "tools/report/plot/plot.h"
#include "tools/report/plot/plot_axis.h"

namespace raycheck::tools {

inline constexpr std::string_view kPlotGrey = "#777777";
inline constexpr std::string_view kPlotDefects = "#9e3700";
// gnuplot's point types.
inline constexpr int kPlotCross = 2;
inline constexpr int kOpenCircle = 6;
inline constexpr int kFilledCircle = 7;

/// Where numbers lie in the frame of a plot, and its size in pixels.
struct PlotFrame {
  double width = 0, height = 0;
  PlotAxis x, y;
};

/// "#rrggbb"
std::string_view series_colour(const PlotSeries& series);
/// The lines of a data block, in pixels of the frame.
std::string series_data(const PlotSeries& series, const PlotFrame& frame);
/// The elements of a plot command that draw that block, the first at the back.
std::vector<std::string> series_parts(const PlotSeries& series, const std::string& block);

}  // namespace raycheck::tools
