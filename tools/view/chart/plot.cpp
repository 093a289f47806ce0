#include <fmt/core.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <utility>

#include "tools/report/output_file.h"
#include "tools/report/words.h"
#include "tools/view/chart/chart.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr int kNotFound = 127;  ///< What a shell exits with where there is no such program.
constexpr int kWide = 1000, kTall = 640;  ///< Of each plot, in pixels.
constexpr int kPixelsPerInch = 100;       ///< In files that measure in inches.
constexpr std::size_t kMostTicks = 16;
constexpr double kMostPowers = 12;  ///< Of ten, beside an axis.
/// Of ten; beyond, errors are drawn there: gnuplot has doubles.
constexpr double kMostPower = 250;
constexpr double kRow = 0.06;  ///< Of the axis, between the errors and 0 or infinity.

/// Okabe and Ito's colours (Color Universal Design, 2008), which most colour-blind readers tell
/// apart, without yellow, which is lost on white.
constexpr std::array<std::string_view, 7> kColours = {"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                                      "#56b4e9", "#d55e00", "#000000"};
/// gnuplot's point types that are filled; the same one open is the number before.
constexpr std::array<int, 6> kFilled = {7, 5, 9, 13, 11, 15};
constexpr std::string_view kDefectLook = "pt 2 lc rgb '#9e3700' lw 1.8";
constexpr std::string_view kGreyLine = "lc rgb '#777777' lw 1.5 dt";

constexpr std::pair<std::string_view, std::string_view> kTerminals[] = {
    {".svg", "svg dynamic"}, {".png", "pngcairo"}, {".pdf", "pdfcairo"}};

/// gnuplot's name of what writes such a file; empty where there is none.
std::string_view terminal_of(const std::string& path) {
  const std::string extension = fs::path(path).extension();
  for (const auto& [known, terminal] : kTerminals) {
    if (known == extension) return terminal;
  }
  return {};
}

/// A string of gnuplot's, in which nothing acts.
std::string in_quotes(std::string_view text) {
  return "'" + boost::replace_all_copy(std::string(text), "'", "''") + "'";
}

std::optional<double> error_of(const std::optional<ChartPoint>& point) {
  return point ? point->errors.front().at[kChartShare] : std::nullopt;
}

/// A method's points of a facet: its one point over run times, or those over severities.
std::vector<std::optional<ChartPoint>> points_of(const ChartSeries& series,
                                                 const ChartFacet& facet) {
  if (facet.baseline.empty()) return series.points;
  return {series.time ? series.whole : std::nullopt};
}

/// Powers of ten, with rows for errors of 0 and infinity, which such an axis has no place for.
struct ErrorAxis {
  double low = kMostPower, high = -kMostPower;
  bool has_zero = false, has_infinity = false;

  void take(const std::optional<double>& error) {
    if (!error) return;
    has_zero = has_zero || *error == 0;
    has_infinity = has_infinity || std::isinf(*error);
    if (*error == 0 || std::isinf(*error)) return;
    const double power = std::clamp(std::log10(*error), -kMostPower, kMostPower);
    low = std::min(low, power);
    high = std::max(high, power);
  }
  void complete() {
    if (low > high) low = high = 0;
    const double room = std::max(0.2, (1 - (high - low)) / 2);
    low -= room;
    high += room;
  }
  double row() const { return std::max(0.3, (high - low) * kRow); }
  double zero() const { return std::pow(10, low - row()); }
  double infinity() const { return std::pow(10, high + row()); }
  double place(double error) const {
    return error == 0          ? zero()
           : std::isinf(error) ? infinity()
                               : std::clamp(error, std::pow(10, low), std::pow(10, high));
  }
  std::string text() const {
    // No power of ten is written beside 0 or "infinite".
    const double every = std::ceil((high - low) / kMostPowers);
    std::string told = fmt::format(
        "set yrange [{:g}:{:g}]\n{} mytics\nset ytics {:g},{:g},{:g} format '10^{{%T}}'\n",
        has_zero ? zero() / 1.5 : std::pow(10, low),
        has_infinity ? infinity() * 1.5 : std::pow(10, high), every > 1 ? "unset" : "set",
        std::pow(10, every * std::ceil(low / every)), std::pow(10, every), std::pow(10, high));
    if (has_zero) told += fmt::format("set ytics add ('0' {:g})\n", zero());
    if (has_infinity) told += fmt::format("set ytics add ('infinite' {:g})\n", infinity());
    return told;
  }
};

ErrorAxis axis_of(const ChartFacet& facet) {
  ErrorAxis axis;
  for (const ChartSeries& series : facet.series) {
    for (const auto& point : points_of(series, facet)) {
      axis.take(error_of(point));
      if (point && facet.baseline.empty()) axis.take(point->errors.front().condition[kChartShare]);
    }
  }
  axis.complete();
  return axis;
}

/// Lines of x, y, the mark, y again where something is wrong without an excuse, and of run times
/// where the middle half lies.
std::string data_of(const ChartSeries& series, const ChartFacet& facet, const ErrorAxis& axis) {
  const int filled = kFilled[series.number % kFilled.size()];
  const auto points = points_of(series, facet);
  std::string text;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto error = error_of(points[k]);
    if (!error) {
      text += "\n";
      continue;
    }
    const double y = axis.place(*error);
    const ChartTime time =
        facet.baseline.empty() ? ChartTime{static_cast<double>(k), 0, 0} : *series.time;
    text +=
        fmt::format("{:g} {:g} {} {} {:g} {:g}\n", time.ratio, y,
                    points[k]->wrong > 0 || points[k]->defects > 0 ? filled - 1 : filled,
                    points[k]->defects > 0 ? fmt::format("{:g}", y) : "NaN", time.low, time.high);
  }
  return text;
}

/// The front of those without defects, over run times.
std::string front_data(const ChartFacet& facet, const ErrorAxis& axis) {
  std::vector<std::pair<double, double>> places;
  for (const ChartSeries& series : facet.series) {
    const auto point = points_of(series, facet).front();
    if (!error_of(point) || !point->errors.front().is_front[kChartShare]) continue;
    places.emplace_back(series.time->ratio, axis.place(*error_of(point)));
  }
  std::sort(places.begin(), places.end());
  std::string text;
  for (const auto& [x, y] : places) text += fmt::format("{:g} {:g}\n", x, y);
  return text;
}

/// What the problem itself magnifies errors by at each severity, whoever was asked there.
std::string kappa_data(const ChartFacet& facet, const ErrorAxis& axis) {
  std::string text;
  for (std::size_t k = 0; k < facet.severities.size(); ++k) {
    for (const ChartSeries& series : facet.series) {
      if (!series.points[k]) continue;
      const auto kappa = series.points[k]->errors.front().condition[kChartShare];
      if (!kappa) continue;
      text += fmt::format("{} {:g}\n", k, axis.place(*kappa));
      break;
    }
  }
  return text;
}

std::string severities_text(const ChartFacet& facet) {
  const std::size_t every = facet.severities.size() / kMostTicks + 1;
  std::string ticks;
  for (std::size_t k = 0; k < facet.severities.size(); k += every) {
    ticks += fmt::format("{}{} {}", k == 0 ? "" : ", ", in_quotes(facet.severities[k]), k);
  }
  return fmt::format("set xtics ({})\nset xrange [-0.3:{:g}]\n", ticks,
                     static_cast<double>(facet.severities.size()) - 0.7);
}

std::string axes_of(const ChartFacet& facet, const ErrorAxis& axis) {
  const properties::Quantity quantity = facet.quantities.front();
  std::string text = fmt::format(
      "set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n",
      in_quotes(chart_title(facet)), in_quotes(chart_under(facet)),
      in_quotes(fmt::format("{} {}, {}", kChartShares[kChartShare].name, chart_error(quantity),
                            unit_name(quantity, facet.precision))));
  text += axis.text();
  const bool is_timed = !facet.baseline.empty();
  return text + (is_timed ? "set logscale x\nset xtics autofreq\nset xrange [*:*]\n"
                          : "unset logscale x\n" + severities_text(facet));
}

/// An element of a plot command that has no entry in the key.
std::string element(const std::string& data, std::string_view look) {
  return fmt::format("{} using {} notitle, \\\n  ", data, look);
}

std::string keyentry(std::string_view look, std::string_view text) {
  return fmt::format("keyentry {} title {}, \\\n  ", look, in_quotes(text));
}

std::string plot_of(const ChartFacet& facet) {
  const ErrorAxis axis = axis_of(facet);
  const bool is_timed = !facet.baseline.empty();
  std::string data = fmt::format("$grey << EOD\n{}EOD\n",
                                 is_timed ? front_data(facet, axis) : kappa_data(facet, axis));
  std::string parts = element(
      "$grey",
      fmt::format("1:2 with {} {} 2", is_timed ? "steps" : "linespoints pt 7 ps 0.3", kGreyLine));
  std::string key = keyentry(fmt::format("with lines {} 2", kGreyLine),
                             is_timed ? "front without defects" : "kappa of the problem");
  key += keyentry("with points pt 7 lc rgb '#444444'", "decisions right");
  key += keyentry("with points pt 6 lc rgb '#444444'", "wrong, excused");
  key += keyentry(fmt::format("with points {}", kDefectLook), "wrong: defects");
  for (std::size_t k = 0; k < facet.series.size(); ++k) {
    const ChartSeries& series = facet.series[k];
    const std::string block = fmt::format("$data{}", k), points = data_of(series, facet, axis);
    const std::string colour =
        fmt::format("lc rgb '{}' lw 1.8", kColours[series.number % kColours.size()]);
    if (points.find_first_not_of('\n') == std::string::npos) continue;
    data += fmt::format("{} << EOD\n{}EOD\n", block, points);
    parts += is_timed ? element(block, "1:2:5:6 with xerrorbars pt 0 " + colour)
                      : element(block, "1:2 with lines " + colour);
    parts += element(block, "1:2:3 with points pt variable " + colour);
    parts += element(block, fmt::format("1:4 with points {}", kDefectLook));
    key += keyentry(
        fmt::format("with points pt {} {}", kFilled[series.number % kFilled.size()], colour),
        series.name);
  }
  key.erase(key.rfind(','));
  return axes_of(facet, axis) + data + "plot " + parts + key + "\n";
}

}  // namespace

void require_plottable(const std::string& path) {
  if (terminal_of(path).empty()) {
    throw std::invalid_argument("plot " + path + ": the file's name ends in .svg, .png or .pdf");
  }
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) {
    throw std::invalid_argument("plot " + path + ": there is no folder " + folder.string());
  }
  const OutputFile tried("plot", path);  // so that hours of work do not end with an unwritable file
}

std::string gnuplot_script(const std::vector<ChartFacet>& facets, const std::string& path) {
  const int tall = kTall * std::max(1, static_cast<int>(facets.size()));
  const double unit = terminal_of(path) == "pdfcairo" ? kPixelsPerInch : 1;
  std::string script = fmt::format(
      "set terminal {} size {:g},{:g} font 'sans,12' background rgb 'white'\nset output {}\n"
      "set encoding utf8\nset key outside right top Left reverse noenhanced samplen 2\n"
      "set grid lc rgb '#dddddd'\nset border 3\nset tics nomirror\nset logscale y\n"
      "set multiplot layout {},1\n",
      terminal_of(path), kWide / unit, tall / unit, in_quotes(path), tall / kTall);
  for (const ChartFacet& facet : facets) script += plot_of(facet);
  return script + "unset multiplot\n";
}

void draw(const std::vector<ChartFacet>& facets, const std::string& path) {
  require_plottable(path);
  std::string name = fs::temp_directory_path() / "raycheck-plot-XXXXXX";
  const int file = mkstemp(name.data());
  if (file < 0) throw std::runtime_error("plot: no temporary file could be made, " + name);
  close(file);
  const std::unique_ptr<const std::string, void (*)(const std::string*)> remove_at_end(
      &name, [](const std::string* script) {
        std::error_code ignored;
        fs::remove(*script, ignored);
      });
  std::ofstream(name) << gnuplot_script(facets, path);
  FILE* const gnuplot = popen(("gnuplot " + name + " 2>&1").c_str(), "r");
  if (gnuplot == nullptr) throw std::runtime_error("plot: gnuplot could not be started");
  std::string said;
  std::array<char, 512> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), gnuplot) != nullptr) said += buffer.data();
  const int status = pclose(gnuplot);
  if (status != -1 && WIFEXITED(status) && WEXITSTATUS(status) == kNotFound) {
    throw GnuplotMissing("plot " + path +
                         ": no plot was drawn, for gnuplot is not installed (Debian: apt-get "
                         "install gnuplot-nox)");
  }
  if (status != 0) throw std::runtime_error("plot " + path + ": gnuplot failed: " + said);
}

}  // namespace raycheck::tools
