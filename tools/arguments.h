#ifndef RAYCHECK_TOOLS_ARGUMENTS_H_
#define RAYCHECK_TOOLS_ARGUMENTS_H_

// What the commands share of reading arguments and writing reports. Internal to the commands.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/files/scene_file.h"
#include "tools/external/contestant.h"
#include "tools/report/plot.h"
#include "tools/report/view.h"
#include "tools/terminal.h"

namespace raycheck::tools {

/// `count` numbers separated by commas; the error names the option and the text.
std::vector<double> parse_list(const char* option, std::string_view text, std::size_t count,
                               const char* meaning);
/// A whole number from `least`; the error names the option.
std::int64_t parse_index(const char* option, std::string_view text, std::int64_t least);
std::optional<scene::Dialect> parse_dialect(const std::string& text);

/// A bound on errors: a number >= 0.
extern const CLI::Validator kBound;

/// The pairs of methods asked for by --rays and --intersect.
std::vector<MethodPair> chosen_methods(const std::string& rays,
                                       const std::vector<std::string>& intersect);

/// --sandbox, and what it says.
void add_sandbox(CLI::App& command, std::string& sandbox);
Sandbox sandbox_of(const std::string& text);

/// What --candidate, --sandbox, --timeout and --bounds are given.
struct ExternalArguments {
  std::vector<std::string> candidates;
  std::string sandbox = "auto";
  double seconds = Limits{}.seconds;
  std::string bounds;  ///< Whose; empty: kDefaultMethods'.
  double image_change = properties::kExcusedImageChange;
  double threshold = 0;
};
void add_external(CLI::App& command, ExternalArguments& arguments);
/// --image-change and --t-threshold
void add_renderer(CLI::App& command, ExternalArguments& arguments);
/// Each once compiled, where it has to be, and introduced; `dialect` is what renderers read.
std::vector<Contestant> find_contestants(const ExternalArguments& arguments,
                                         std::optional<scene::Dialect> dialect = {});

/// --format, one of those names; the first where it is not given.
void add_format(CLI::App& command, std::string& format, const std::vector<std::string>& formats);
/// The same, of the views of a report.
template <class Report, std::size_t N>
void add_format(CLI::App& command, std::string& format, const View<Report> (&views)[N]) {
  std::vector<std::string> names;
  for (const View<Report>& view : views) names.emplace_back(view.name);
  add_format(command, format, names);
}
/// --certificates FILE
void add_certificates(CLI::App& command, std::optional<std::string>& path);
/// --threads; `same` is what does not depend on it.
void add_threads(CLI::App& command, int& threads, std::string_view same);
/// --strict
void add_strict(CLI::App& command, bool& strict);
/// --seed
void add_seed(CLI::App& command, std::uint64_t& seed);

/// Standard error may be closed or full; that is no reason to lose the report.
void print_error(const std::string& text);
void print_warnings(const std::vector<std::string>& warnings);
/// Throws when the report could not be written: a lost report must not look like a good one.
void print_report(const std::string& text);
/// Prints a report in the format of that name.
/// Domain: a name that add_format takes.
template <class Report, std::size_t N>
void print_view(const View<Report> (&views)[N], std::string_view format, const Report& report) {
  for (const View<Report>& view : views) {
    if (view.name == format) print_report(view.render(report, {stdout_takes_colours()}));
  }
}
/// Draws the plots, unless there is no gnuplot: then it says so on standard error.
void draw_or_say(const std::vector<Plot>& plots, const std::string& path);

/// `found`: a defect, or what else fails; `checked`: enough was judged to say that there is none.
int exit_code(bool was_interrupted, bool found, bool checked);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_ARGUMENTS_H_
