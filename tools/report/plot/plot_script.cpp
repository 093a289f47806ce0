#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "tools/report/plot/plot.h"
#include "tools/report/plot/plot_axis.h"
#include "tools/report/plot/plot_labels.h"
#include "tools/report/plot/plot_series.h"

namespace raycheck::tools {
namespace {

constexpr double kPixelsPerInch = 100;  ///< Where the file measures in inches.
constexpr double kWidth = 1000;         ///< Of a picture, in pixels.
constexpr double kHeight = 640;         ///< Of each plot in it.
constexpr double kLeft = 96, kTop = 64, kBottom = 96, kRight = 24;
constexpr double kLeaderRoom = 26;  ///< From the right edge of a plot to the names of its curves.
constexpr double kMark = 9;         ///< Half a mark.

/// A string of gnuplot's; within single quotes only the quote is special.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

template <class Take>
void for_each_point(const Plot& plot, Take take) {
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) {
      if (!std::isnan(point.y)) take(series, point);
    }
  }
}

PlotFrame frame_of(const Plot& plot) {
  std::vector<double> xs;
  std::vector<double> ys;
  double right = kRight;
  for_each_point(plot, [&](const PlotSeries& series, const PlotPoint& point) {
    xs.push_back(point.x);
    ys.push_back(point.y);
    if (series.style == PlotSeries::Style::kPoint) {
      xs.push_back(point.x_low);
      xs.push_back(point.x_high);
    } else {
      right = std::max(right, kLeaderRoom + text_width(series.name));
    }
  });
  const double width = kWidth - kLeft - right;
  const double height = kHeight - kTop - kBottom;
  return {width, height,
          plot.log_x ? PlotAxis::powers(xs, width, false) : PlotAxis::even(xs, width),
          PlotAxis::powers(ys, height, plot.may_cut)};
}

std::string text_at(double x, double y, std::string_view text, std::string_view options = "") {
  return fmt::format("set label {} at {:.1f},{:.1f} {} noenhanced front\n", in_quotes(text), x, y,
                     options);
}

std::string line_from(double x, double y, double to_x, double to_y, std::string_view look) {
  return fmt::format("set arrow from {:.1f},{:.1f} to {:.1f},{:.1f} nohead front {}\n", x, y, to_x,
                     to_y, look);
}

std::string ticks_text(std::string_view axis, const std::vector<PlotAxis::Tick>& ticks,
                       const std::vector<PlotAxis::Row>& rows) {
  std::string text;
  for (const PlotAxis::Tick& tick : ticks) {
    text += fmt::format("{}{} {:.1f}", text.empty() ? "" : ", ", in_quotes(tick.text), tick.at);
  }
  for (const PlotAxis::Row& row : rows) {
    text += fmt::format("{}{} {:.1f}", text.empty() ? "" : ", ", in_quotes(row.text), row.at);
  }
  return fmt::format("set {}tics ({})\n", axis, text);
}

/// The axes, rows of zeros and infinities shaded, zigzags where something is cut out.
std::string axes_text(const Plot& plot, const PlotFrame& frame, double bottom,
                      double picture_height) {
  std::string text = "unset label\nunset arrow\nunset object\n";
  text += fmt::format("set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n",
                      kLeft / kWidth, (kLeft + frame.width) / kWidth);
  text += fmt::format("set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n",
                      bottom / picture_height, (bottom + frame.height) / picture_height);
  text += fmt::format("set xrange [0:{:.1f}]\nset yrange [0:{:.1f}]\n", frame.width, frame.height);
  text += fmt::format("set xlabel {} noenhanced\n", in_quotes(plot.x_label));
  text += text_at(10 - kLeft, frame.height + 44, plot.title, "font 'sans-Bold,13'");
  text += text_at(10 - kLeft, frame.height + 18, plot.y_label);
  text += ticks_text("x", frame.x.ticks(), {}) + ticks_text("y", frame.y.ticks(), frame.y.rows());
  for (const PlotAxis::Row& row : frame.y.rows()) {
    text += fmt::format(
        "set object rectangle from 0,{:.1f} to {:.1f},{:.1f} fc rgb '#f0f0ee' fs solid noborder "
        "behind\n",
        row.at - kRow / 2, frame.width, row.at + kRow / 2);
  }
  for (const double at : frame.y.cuts()) {
    text += fmt::format(
        "set object rectangle from -4,{:.1f} to {:.1f},{:.1f} fc rgb 'white' fs solid noborder "
        "front\n",
        at - kCut / 4, frame.width + 4, at + kCut / 4);
    for (const double edge : {at - kCut / 4, at + kCut / 4}) {
      text += line_from(-8, edge - 3, 8, edge + 3, "lc rgb '#444444'");
      text += line_from(8, edge, frame.width, edge, "lc rgb '#bbbbbb' dt (2,4)");
    }
  }
  return text;
}

/// Names beside the ends of curves.
std::string curve_names(const Plot& plot, const PlotFrame& frame) {
  std::vector<const PlotSeries*> named;
  std::vector<std::array<double, 2>> ends;
  std::vector<double> wanted;
  for (const PlotSeries& series : plot.series) {
    if (series.style != PlotSeries::Style::kCurve && series.style != PlotSeries::Style::kDashes) {
      continue;
    }
    const auto last = std::find_if(series.points.rbegin(), series.points.rend(),
                                   [](const PlotPoint& point) { return !std::isnan(point.y); });
    if (last == series.points.rend()) continue;
    named.push_back(&series);
    ends.push_back({frame.x.place(last->x), frame.y.place(last->y)});
    wanted.push_back(ends.back()[1]);
  }
  const std::vector<double> places = spread_apart(wanted, kLine, 0, frame.height);
  std::string text;
  for (std::size_t k = 0; k < named.size(); ++k) {
    const bool is_grey = named[k]->style == PlotSeries::Style::kDashes;
    const std::string look =
        fmt::format("lc rgb '{}'", is_grey ? kPlotGrey : series_colour(*named[k]));
    const double joint = frame.width + kLeaderRoom - 6;
    const double edge = frame.width + 6;
    if (ends[k][0] + kMark < frame.width) {
      text += line_from(ends[k][0] + kMark, ends[k][1], edge, ends[k][1], look + " dt (1,4)");
    }
    text += line_from(edge, ends[k][1], joint, places[k], look);
    text += text_at(joint + 3, places[k], named[k]->name, is_grey ? "tc rgb '#777777'" : "");
  }
  return text;
}

/// Names beside points.
std::string point_names(const Plot& plot, const PlotFrame& frame) {
  std::vector<NamedPoint> points;
  std::vector<PlotObstacle> obstacles;
  for_each_point(plot, [&](const PlotSeries& series, const PlotPoint& point) {
    if (series.style != PlotSeries::Style::kPoint) return;
    const double x = frame.x.place(point.x);
    const double y = frame.y.place(point.y);
    const double low = frame.x.place(point.x_low);
    points.push_back({x, y, series.name});
    obstacles.push_back({{x - kMark, y - kMark, 2 * kMark, 2 * kMark}});
    obstacles.push_back({{low, y - 2, frame.x.place(point.x_high) - low, 4}, true});
  });
  for (const PlotSeries& series : plot.series) {
    if (series.style != PlotSeries::Style::kSteps) continue;
    for (std::size_t k = 1; k < series.points.size(); ++k) {
      const double x = frame.x.place(series.points[k - 1].x);
      const double y = frame.y.place(series.points[k - 1].y);
      const double to_x = frame.x.place(series.points[k].x);
      const double to_y = frame.y.place(series.points[k].y);
      obstacles.push_back({{x, y - 2, to_x - x, 4}, true});
      obstacles.push_back({{to_x - 2, to_y, 4, y - to_y}, true});
    }
  }
  for (const double at : frame.y.cuts()) {
    obstacles.push_back({{0, at - kCut / 2, frame.width, kCut}, true});
  }
  const auto names = names_beside(points, obstacles, {2, 2, frame.width - 4, frame.height - 4});
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const PlacedName& name = names[k];
    if (name.needs_leader) {
      text += line_from(points[k].x, points[k].y, name.joint[0], name.joint[1],
                        "lc rgb '#999999' lw 0.7");
    }
    const double edge = name.ends_here ? name.box.left + name.box.width : name.box.left;
    text += text_at(edge, name.box.bottom + name.box.height / 2, points[k].name,
                    name.ends_here ? "right" : "left");
  }
  return text;
}

/// What the marks mean, below the axis.
std::string legend_text(const Plot& plot) {
  constexpr double kBelow = -68;
  double x = 0;
  std::string text;
  const auto entry = [&](int mark, std::string_view colour, std::string_view meaning) {
    text += text_at(x, kBelow, "", fmt::format("point pt {} ps 1.1 lc rgb '{}'", mark, colour));
    text += text_at(x + 12, kBelow, meaning);
    x += 30 + text_width(meaning);
  };
  entry(kFilledCircle, "#444444", "every decision right");
  entry(kOpenCircle, "#444444", "wrong, all excused");
  text += text_at(x, kBelow, "", fmt::format("point pt {} ps 1.1 lc rgb '#444444'", kOpenCircle));
  entry(kPlotCross, kPlotDefects, "wrong: defects");
  if (!plot.steps_mean.empty()) {
    text += line_from(x, kBelow, x + 30, kBelow, fmt::format("lc rgb '{}' lw 2 dt 3", kPlotGrey));
    text += text_at(x + 38, kBelow, plot.steps_mean);
  }
  return text;
}

std::string script_of(const Plot& plot, double bottom, double picture_height) {
  const PlotFrame frame = frame_of(plot);
  std::string script = axes_text(plot, frame, bottom + kBottom, picture_height);
  script += curve_names(plot, frame) + point_names(plot, frame) + legend_text(plot);
  std::string parts;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const std::string data = fmt::format("$data{}", k);
    script += data + " << EOD\n" + series_data(plot.series[k], frame) + "EOD\n";
    for (const std::string& part : series_parts(plot.series[k], data)) {
      parts += fmt::format("{}{} notitle", parts.empty() ? "plot " : ", \\\n  ", part);
    }
  }
  return script + parts + "\n";
}

}  // namespace

std::string gnuplot_script(const std::vector<Plot>& plots, const std::string& path) {
  const PlotTerminal terminal = plot_terminal(path);
  const double height = kHeight * static_cast<double>(plots.size());
  const double unit = terminal.in_inches ? kPixelsPerInch : 1;
  std::string script = fmt::format(
      "set terminal {} size {:g},{:g} font 'sans,12' background rgb 'white'\nset output {}\n",
      terminal.name, kWidth / unit, height / unit, in_quotes(path));
  script +=
      "set encoding utf8\nunset key\nset grid lc rgb '#dddddd'\nset border 3 lc rgb '#444444'\n"
      "set tics nomirror\nset multiplot\n";
  double bottom = height;
  for (const Plot& plot : plots) script += script_of(plot, bottom -= kHeight, height);
  return script + "unset multiplot\n";
}

}  // namespace raycheck::tools
