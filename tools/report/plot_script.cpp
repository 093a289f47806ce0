#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "tools/report/plot.h"
#include "tools/report/plot_axis.h"
#include "tools/report/plot_labels.h"

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
constexpr std::array<Shape, 6> kShapes = {{{7, 6}, {5, 4}, {9, 8}, {13, 12}, {11, 10}, {15, 14}}};
constexpr int kCrossMark = 2;
constexpr std::array<std::string_view, 5> kDashes = {"solid", "(9,4)", "(2,3)", "(9,3,2,3)",
                                                     "(5,3,2,3,2,3)"};
static_assert(kColours.size() * kShapes.size() == kPlotLooks);

constexpr std::string_view kGrey = "#777777";
constexpr std::string_view kOfDefects = "#9e3700";

constexpr double kPixelsPerInch = 100;  ///< Where the file measures in inches.
constexpr double kWidth = 1000;         ///< Of a picture, in pixels.
constexpr double kHeight = 640;         ///< Of each plot in it.
constexpr double kLeft = 96, kTop = 44, kBottom = 96, kRight = 24;
constexpr double kLeaderRoom = 26;  ///< From the right edge of a plot to the names of its curves.
constexpr double kMark = 7;         ///< Half a mark.

/// A string of gnuplot's; within single quotes only the quote is special.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string_view colour_of(const PlotSeries& series) {
  return kColours[series.number % kColours.size()];
}

/// A plot's frame in pixels, from its lower left corner, and where numbers lie in it.
struct Frame {
  double width = 0, height = 0;
  PlotAxis x, y;
};

template <class Take>
void for_each_point(const Plot& plot, Take take) {
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) {
      if (!std::isnan(point.y)) take(series, point);
    }
  }
}

Frame frame_of(const Plot& plot) {
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
      right = std::max(right, kLeaderRoom + kLetter * static_cast<double>(series.name.size()));
    }
  });
  const double width = kWidth - kLeft - right;
  const double height = kHeight - kTop - kBottom;
  return {width, height,
          plot.log_x ? PlotAxis::powers(xs, width, false) : PlotAxis::even(xs, width),
          PlotAxis::powers(ys, height, plot.may_cut)};
}

std::string text_at(double x, double y, std::string_view text, std::string_view options = "") {
  return fmt::format("set label {} at {:.1f},{:.1f} noenhanced front {}\n", in_quotes(text), x, y,
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
std::string axes_text(const Plot& plot, const Frame& frame, double bottom, double picture_height) {
  std::string text = "unset label\nunset arrow\nunset object\n";
  text += fmt::format("set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n",
                      kLeft / kWidth, (kLeft + frame.width) / kWidth);
  text += fmt::format("set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n",
                      bottom / picture_height, (bottom + frame.height) / picture_height);
  text += fmt::format("set xrange [0:{:.1f}]\nset yrange [0:{:.1f}]\n", frame.width, frame.height);
  text +=
      fmt::format("set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n",
                  in_quotes(plot.title), in_quotes(plot.x_label), in_quotes(plot.y_label));
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
std::string curve_names(const Plot& plot, const Frame& frame) {
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
    const std::string look = fmt::format("lc rgb '{}'", is_grey ? kGrey : colour_of(*named[k]));
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
std::string point_names(const Plot& plot, const Frame& frame) {
  std::vector<NamedPoint> points;
  std::vector<PlotBox> obstacles;
  for_each_point(plot, [&](const PlotSeries& series, const PlotPoint& point) {
    if (series.style != PlotSeries::Style::kPoint) return;
    const double x = frame.x.place(point.x);
    const double y = frame.y.place(point.y);
    const double low = std::min(x - kMark, frame.x.place(point.x_low));
    const double high = std::max(x + kMark, frame.x.place(point.x_high));
    points.push_back({x, y, series.name});
    obstacles.push_back({low, y - kMark, high - low, 2 * kMark});
  });
  for (const double at : frame.y.cuts()) {
    obstacles.push_back({0, at - kCut / 2, frame.width, kCut});
  }
  const auto names = names_beside(points, obstacles, {2, 2, frame.width - 4, frame.height - 4});
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const PlacedName& name = names[k];
    if (name.needs_leader) {
      text += line_from(points[k].x, points[k].y, name.joint[0], name.joint[1],
                        "lc rgb '#999999' lw 0.7");
    }
    text += text_at(name.box.left + 2, name.box.bottom + name.box.height / 2, points[k].name);
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
    x += 36 + kLetter * static_cast<double>(meaning.size());
  };
  entry(kShapes[0].filled, "#444444", "every decision right");
  entry(kShapes[0].open, "#444444", "wrong, all excused");
  text +=
      text_at(x, kBelow, "", fmt::format("point pt {} ps 1.1 lc rgb '#444444'", kShapes[0].open));
  entry(kCrossMark, kOfDefects, "wrong: defects");
  if (!plot.steps_mean.empty()) {
    text += line_from(x, kBelow, x + 30, kBelow, fmt::format("lc rgb '{}' lw 2 dt 3", kGrey));
    text += text_at(x + 38, kBelow, plot.steps_mean);
  }
  return text;
}

/// x, y, filled or open, y again where an outline is drawn, where a cross is, low and high x.
std::string data_text(const PlotSeries& series, const Frame& frame) {
  std::string text;
  const Shape shape = kShapes[series.number % kShapes.size()];
  for (const PlotPoint& point : series.points) {
    if (std::isnan(point.y)) {
      text += "\n";
      continue;
    }
    const std::string y = fmt::format("{:.2f}", frame.y.place(point.y));
    const bool is_right = point.standing == PlotStanding::kRight;
    const bool is_defect = point.standing == PlotStanding::kDefect;
    text += fmt::format("{:.2f} {} {} {} {}", frame.x.place(point.x), y,
                        is_right ? shape.filled : shape.open, is_right ? y : "NaN",
                        is_defect ? y : "NaN");
    if (series.style == PlotSeries::Style::kPoint) {
      text +=
          fmt::format(" {:.2f} {:.2f}", frame.x.place(point.x_low), frame.x.place(point.x_high));
    }
    text += "\n";
  }
  return text;
}

/// What draws a series of those data.
std::vector<std::string> parts_of(const PlotSeries& series, const std::string& data) {
  const std::string colour = fmt::format("lc rgb '{}'", colour_of(series));
  const Shape shape = kShapes[series.number % kShapes.size()];
  const bool is_point = series.style == PlotSeries::Style::kPoint;
  const double size = is_point ? 1.3 : 0.8;
  std::vector<std::string> parts;
  switch (series.style) {
    case PlotSeries::Style::kDashes:
      return {fmt::format("{} using 1:2 with lines lc rgb '{}' lw 1.5 dt (8,6)", data, kGrey)};
    case PlotSeries::Style::kSteps:
      return {fmt::format("{} using 1:2 with steps lc rgb '{}' lw 2 dt 3", data, kGrey)};
    case PlotSeries::Style::kPoint:
      parts.push_back(fmt::format("{} using 1:2:6:7 with xerrorbars pt 0 {} lw 1.5", data, colour));
      break;
    case PlotSeries::Style::kCurve:
      parts.push_back(fmt::format("{} using 1:2 with lines {} lw 1.8 dt {}", data, colour,
                                  kDashes[series.number % kDashes.size()]));
      break;
  }
  parts.push_back(
      fmt::format("{} using 1:2:3 with points pt variable ps {} {} lw 2", data, size, colour));
  parts.push_back(fmt::format("{} using 1:4 with points pt {} ps {} lc rgb '#333333' lw 0.7", data,
                              shape.open, size));
  parts.push_back(fmt::format("{} using 1:5 with points pt {} ps {} lc rgb '{}' lw 1.8", data,
                              kCrossMark, size, kOfDefects));
  return parts;
}

std::string script_of(const Plot& plot, double bottom, double picture_height) {
  const Frame frame = frame_of(plot);
  std::string script = axes_text(plot, frame, bottom + kBottom, picture_height);
  script += curve_names(plot, frame) + point_names(plot, frame) + legend_text(plot);
  std::string parts;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const std::string data = fmt::format("$data{}", k);
    script += data + " << EOD\n" + data_text(plot.series[k], frame) + "EOD\n";
    for (const std::string& part : parts_of(plot.series[k], data)) {
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
