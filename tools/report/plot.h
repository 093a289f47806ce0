#ifndef RAYCHECK_TOOLS_REPORT_PLOT_H_
#define RAYCHECK_TOOLS_REPORT_PLOT_H_

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace raycheck::tools {

struct PlotPoint {
  double x = 0;
  double y = 0;
  double x_low = 0;  ///< Where the series has spreads: from where to where x was seen.
  double x_high = 0;
};

struct PlotSeries {
  enum class Style { kLines, kPoints, kPointsWithSpread, kDashes, kSteps };
  std::string name;  ///< In the legend; empty: not there.
  Style style = Style::kLines;
  std::vector<PlotPoint> points;                     ///< None: only a line of the legend.
  int mark = 7;                                      ///< gnuplot's point type.
  std::optional<std::string> colour = std::nullopt;  ///< "#rrggbb"; empty: one of its own.
};

struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool log_x = false;
  bool log_y = true;
  std::vector<PlotSeries> series;
};

/// Throws std::invalid_argument unless a plot may be drawn to that file: its name ends in .svg,
/// .png or .pdf, and its folder exists.
void require_plottable(const std::string& path);

/// Errors below are drawn there: a logarithm has no place for 0.
inline constexpr double kSmallestPlotted = 0.1;
/// Infinite errors are drawn there.
inline constexpr double kLargestPlotted = 1e20;

/// There is no gnuplot to draw with.
class GnuplotMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Draws plots below one another into one file, by gnuplot. Throws GnuplotMissing, or
/// std::runtime_error with gnuplot's message when it fails.
void draw(const std::vector<Plot>& plots, const std::string& path);

/// What gnuplot is told; draw() runs it.
std::string gnuplot_script(const std::vector<Plot>& plots, const std::string& path);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_REPORT_PLOT_H_
