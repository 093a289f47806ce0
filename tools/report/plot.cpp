#include "tools/report/plot.h"

#include <fmt/core.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

/// Colours that differ for most colour-blind readers too; more series than these take them again.
constexpr std::array<std::string_view, 20> kColours = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000",
    "#7f3c8d", "#80ba5a", "#e73f74", "#a5aa99", "#8c564b", "#1f3a93", "#b8860b",
    "#00a6a6", "#ff6f61", "#6b8e23", "#9370db", "#c71585", "#708090"};

constexpr int kWidth = 1000;         ///< Of a picture, in pixels.
constexpr int kHeight = 680;         ///< Of each plot in it.
constexpr int kPixelsPerInch = 100;  ///< Where the file measures in inches.

struct Terminal {
  std::string_view extension;
  std::string_view name;
  bool in_inches;
};
constexpr std::array<Terminal, 3> kTerminals = {
    {{".svg", "svg dynamic", false}, {".png", "pngcairo", false}, {".pdf", "pdfcairo", true}}};

const Terminal* terminal_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  for (const Terminal& terminal : kTerminals) {
    if (terminal.extension == extension) return &terminal;
  }
  return nullptr;
}

/// A string of gnuplot's; within single quotes only the quote is special.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

bool is_installed(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string file = std::string(rest.substr(0, end)) + "/" + program;
    if (access(file.c_str(), X_OK) == 0) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

std::string style(const PlotSeries& series, const std::string& colour) {
  const std::string line = fmt::format("lc rgb {} lw 2", in_quotes(colour));
  const std::string mark = fmt::format("pt {} ps 1.3", series.mark);
  switch (series.style) {
    case PlotSeries::Style::kLines:
      return fmt::format("with linespoints {} pt {} ps 0.6", line, series.mark);
    case PlotSeries::Style::kPoints:
      return fmt::format("with points {} {}", line, mark);
    case PlotSeries::Style::kPointsWithSpread:
      return fmt::format("with xerrorbars {} {}", line, mark);
    case PlotSeries::Style::kSteps:
      return fmt::format("with steps {} dt 3", line);
    default:
      return fmt::format("with lines {} dt 2", line);
  }
}

std::string script_of(const Plot& plot) {
  std::string script;
  script += fmt::format("set title {}\nset xlabel {} offset 0,0.5\nset ylabel {}\n",
                        in_quotes(plot.title), in_quotes(plot.x_label), in_quotes(plot.y_label));
  script += plot.log_x ? "set logscale x\nset format x '10^{%L}'\n"
                       : "unset logscale x\nset format x '%g'\n";
  script += plot.log_y ? "set logscale y\nset format y '10^{%L}'\n"
                       : "unset logscale y\nset format y '%g'\n";
  std::string parts;
  std::size_t colour = 0;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    const std::string ink =
        series.colour ? *series.colour : std::string(kColours[colour++ % kColours.size()]);
    script += fmt::format("$data{} << EOD\n", k);
    for (std::size_t at = 0; at < series.points.size(); ++at) {
      const PlotPoint& point = series.points[at];
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
      script +=
          fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", point.x, point.y, point.x_low, point.x_high);
    }
    script += "EOD\n";
    if (series.points.empty()) {  // a line of the legend
      parts += fmt::format("{}keyentry {} title {}", parts.empty() ? "plot " : ", \\\n  ",
                           style(series, ink), in_quotes(series.name));
      continue;
    }
    const bool spread = series.style == PlotSeries::Style::kPointsWithSpread;
    const std::string title = series.name.empty()
                                  ? "notitle"
                                  : fmt::format("title {} noenhanced", in_quotes(series.name));
    parts += fmt::format("{}$data{} using {} {} {}", parts.empty() ? "plot " : ", \\\n  ", k,
                         spread ? "1:2:3:4" : "1:2", style(series, ink), title);
  }
  return script + parts + "\n";
}

}  // namespace

std::string gnuplot_script(const std::vector<Plot>& plots, const std::string& path) {
  const Terminal* terminal = terminal_of(path);
  const int height = kHeight * static_cast<int>(plots.size());
  const std::string size = terminal->in_inches
                               ? fmt::format("{},{}", static_cast<double>(kWidth) / kPixelsPerInch,
                                             static_cast<double>(height) / kPixelsPerInch)
                               : fmt::format("{},{}", kWidth, height);
  std::string script =
      fmt::format("set terminal {} size {} font 'sans,12' background rgb 'white'\nset output {}\n",
                  terminal->name, size, in_quotes(path));
  script +=
      "set encoding utf8\nset key below maxrows 7 Left reverse noenhanced width 1\n"
      "set grid lc rgb '#dddddd'\nset border lc rgb '#444444'\nset tics nomirror\n";
  if (plots.size() > 1) script += fmt::format("set multiplot layout {},1\n", plots.size());
  for (const Plot& plot : plots) script += script_of(plot);
  if (plots.size() > 1) script += "unset multiplot\n";
  return script;
}

void require_plottable(const std::string& path) {
  if (terminal_of(path) == nullptr) {
    throw std::invalid_argument("plot " + path + ": the file's name ends in .svg, .png or .pdf");
  }
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw std::invalid_argument("plot " + path + ": there is no folder " + folder.string());
  }
  const OutputFile tried("plot", path);  // hours of work do not end in a file that is not written
}

void draw(const std::vector<Plot>& plots, const std::string& path) {
  require_plottable(path);
  if (!is_installed("gnuplot")) {
    throw GnuplotMissing("plot " + path +
                         ": no plot was drawn, for gnuplot is not installed (Debian: apt-get "
                         "install gnuplot-nox)");
  }
  std::string name = std::filesystem::temp_directory_path() / "raycheck-plot-XXXXXX";
  const int file = mkstemp(name.data());
  if (file < 0) throw std::runtime_error("plot: no temporary file could be made, " + name);
  close(file);
  const std::unique_ptr<const std::string, void (*)(const std::string*)> remove_at_end(
      &name, [](const std::string* path_of_script) {
        std::error_code ignored;
        std::filesystem::remove(*path_of_script, ignored);
      });
  std::ofstream(name) << gnuplot_script(plots, path);
  FILE* const gnuplot = popen(("gnuplot " + name + " 2>&1").c_str(), "r");
  if (gnuplot == nullptr) throw std::runtime_error("plot: gnuplot could not be started");
  std::string said;
  std::array<char, 512> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), gnuplot) != nullptr) said += buffer.data();
  const int status = pclose(gnuplot);
  if (status == -1 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("plot " + path + ": gnuplot failed: " + said);
  }
}

}  // namespace raycheck::tools
