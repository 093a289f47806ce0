#include "tools/report/plot/plot.h"

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

constexpr std::pair<std::string_view, PlotTerminal> kTerminals[] = {
    {".svg", {"svg dynamic"}}, {".png", {"pngcairo"}}, {".pdf", {"pdfcairo", true}}};

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

}  // namespace

PlotStanding standing_of(const properties::Verdict& verdict) {
  bool is_wrong = false;
  for (const auto& [quantity, tally] : verdict.tallies()) {
    if (tally.count(properties::Outcome::kWrongDecision) > 0) return PlotStanding::kDefect;
    is_wrong = is_wrong || tally.wrong_answers() > 0;
  }
  return is_wrong ? PlotStanding::kExcused : PlotStanding::kRight;
}

PlotTerminal plot_terminal(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  for (const auto& [known, terminal] : kTerminals) {
    if (known == extension) return terminal;
  }
  return {};
}

void require_plottable(const std::string& path) {
  if (plot_terminal(path).name.empty()) {
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
