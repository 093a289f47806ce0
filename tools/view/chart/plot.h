#pragma once

// Facets of a chart as a picture, drawn by gnuplot.

#include <stdexcept>
#include <string>
#include <vector>

#include "tools/view/chart/chart.h"

namespace raycheck::tools {

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
