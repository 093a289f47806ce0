#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "properties/verdict.h"

namespace raycheck::tools {

/// What the decisions behind an error were.
enum class PlotStanding { kRight, kExcused, kDefect };

PlotStanding standing_of(const properties::Verdict& verdict);

struct PlotPoint {
  double x = 0;
  double y = 0;  ///< >= 0, or infinite; what is no number breaks a curve.
  PlotStanding standing = PlotStanding::kRight;
  double x_low = 0;  ///< Of points: from where to where x was seen.
  double x_high = 0;
};

struct PlotSeries {
  enum class Style {
    kCurve,   ///< With a mark at each point, and its name beside its end.
    kPoint,   ///< One point, with its name beside it.
    kDashes,  ///< A curve in grey without marks.
    kSteps    ///< From point to point in steps, in grey, behind all others; it has no name.
  };
  std::string name;
  Style style = Style::kCurve;
  std::vector<PlotPoint> points;
  std::size_t number = 0;  ///< Tells its shape, its colour and its dashes.
};

struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool log_x = false;
  bool may_cut = false;  ///< Stretches of errors in which nothing lies are cut out.
  std::vector<PlotSeries> series;
  std::string steps_mean;  ///< What kSteps are; empty: there are none.
};

/// So many numbers of series have looks that differ.
inline constexpr std::size_t kPlotLooks = 42;

/// Throws std::invalid_argument unless a plot may be drawn to that file: its name ends in .svg,
/// .png or .pdf, and its folder exists.
void require_plottable(const std::string& path);

/// There is no gnuplot to draw with.
class GnuplotMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Draws plots below one another into one file, by gnuplot; where things and names lie is computed
/// here. Throws GnuplotMissing, or
/// std::runtime_error with gnuplot's message when it fails.
void draw(const std::vector<Plot>& plots, const std::string& path);

/// What gnuplot is told; draw() runs it (plot_script.cpp).
std::string gnuplot_script(const std::vector<Plot>& plots, const std::string& path);

/// gnuplot's name of the terminal for a file and whether that measures in inches; empty for a name
/// that does not end in .svg, .png or .pdf.
struct PlotTerminal {
  std::string_view name;
  bool in_inches = false;
};
PlotTerminal plot_terminal(const std::string& path);

}  // namespace raycheck::tools
