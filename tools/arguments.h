#pragma once

// How the commands read arguments and write reports. Internal to the commands.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "properties/cases/case_source.h"
#include "scene/files/scene_file.h"
#include "tools/external/locate.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/implementations/built_in.h"
#include "tools/report/output_file.h"
#include "tools/report/view.h"
#include "tools/terminal.h"

namespace raycheck::tools {

/// `count` numbers separated by commas; the error names the option and the text.
std::vector<double> parse_list(const char* option, std::string_view text, std::size_t count,
                               const char* meaning);
/// Doubles represent every whole number up to here.
inline constexpr std::int64_t kMostIndex = 9'000'000'000'000'000;
/// A whole number in this range; the error names the option.
std::int64_t parse_index(const char* option, std::string_view text, std::int64_t least,
                         std::int64_t most = kMostIndex);
/// A pixel, "I,J".
scene::Pixel parse_pixel(const char* option, std::string_view text);
/// The same for a scene's camera; the error also names the scene's file.
scene::Pixel parse_pixel(const char* option, std::string_view text, std::string_view path,
                         const scene::Scene& scene);
/// The dialect of a driver file to be read, from --dialect; empty if the text is.
std::optional<scene::Dialect> parse_dialect(const std::string& text);
/// The form of driver files for renderers, or that each form is tried; empty if the text is.
std::optional<DriverRule> parse_driver(const std::string& text);
void add_dialect(CLI::App& command, std::string& dialect);
/// --dialect, which replaces a rubric's [driver].
void add_rubric_dialect(CLI::App& command, std::string& dialect);

/// Validators: a whole number in this range, in digits; a number in this range, as in scene files.
/// Their errors name the refused value and what is allowed.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);
CLI::Validator number_between(double least, double most);
/// A bound on errors: a finite number >= 0.
extern const CLI::Validator kBound;
/// Rejects an empty value: used for every option.
extern const CLI::Validator kGiven;
/// An option that takes one of these names, those of an enumeration in its order; one that is
/// optional has no default.
template <class Value, std::size_t N>
CLI::Option* add_named(CLI::App& command, const std::string& option, Value& value,
                       const std::array<std::string_view, N>& names, const std::string& meaning) {
  const std::vector<std::string> all(names.begin(), names.end());
  const auto take = [&value, all](const std::string& name) {
    using Enum = std::decay_t<decltype(std::optional(value).value())>;
    value = static_cast<Enum>(std::ranges::find(all, name) - all.begin());
  };
  CLI::Option* const added =
      command.add_option_function<std::string>(option, take, meaning)->check(CLI::IsMember(all));
  if constexpr (std::is_enum_v<Value>) added->default_str(all[static_cast<std::size_t>(value)]);
  return added;
}
/// The largest --cases and --steps.
inline constexpr std::uint64_t kMostCases = 1'000'000'000;

/// An option that takes a whole number in this range; its default is shown.
template <class Count>
CLI::Option* add_number(CLI::App& command, const std::string& option, Count& number,
                        std::uint64_t least, std::uint64_t most, const std::string& meaning) {
  return command.add_option(option, number, meaning)
      ->check(whole_number(least, most))
      ->capture_default_str();
}
/// --cases, with this meaning.
template <class Count>
void add_cases(CLI::App& command, Count& cases, const std::string& meaning) {
  add_number(command, "--cases", cases, 1, kMostCases, meaning);
}

/// The source of cases of that name, SOURCE or SOURCE@SEVERITY; the error names the option.
properties::ChosenSource parse_source(std::string_view option, const std::string& name);

/// The pairs of methods chosen by --rays and --intersect; `field`: the name of the latter.
std::vector<MethodPair> chosen_methods(const std::string& rays,
                                       const std::vector<std::string>& intersect,
                                       const char* field = "intersect");

/// The values of --sandbox and --i-know; the command sets the default.
struct SandboxArguments {
  Sandbox sandbox = Sandbox::kAvailable;
  bool knows = false;
};
CLI::Option* add_sandbox(CLI::App& command, SandboxArguments& arguments);
Sandbox sandbox_of(const SandboxArguments& arguments);

/// The values of --candidate, --sandbox, --timeout and --bounds; the last three need the first.
struct ExternalArguments {
  std::vector<std::string> candidates;
  std::vector<std::string> reads, includes;  ///< Folders that they may read; with headers.
  SandboxArguments sandbox;
  double seconds = Limits{}.seconds;
  std::uint64_t memory_mib = Limits{}.memory >> 20;
  std::string bounds;  ///< The methods whose bounds apply; empty: kDefaultMethods.
  scene::Precision precision = scene::Precision::kDouble;  ///< Of renderers.
  std::optional<double> image_change;                      ///< Empty: the precision's default.
  double threshold = 0;
  std::optional<scene::Origin> origin;  ///< Of renderers; empty: the scene's.
};
void add_external(CLI::App& command, ExternalArguments& arguments);
/// --precision, --image-change, --t-threshold and --origin, which need a --candidate
void add_renderer(CLI::App& command, ExternalArguments& arguments);
/// Compiles each candidate if necessary, and reads its introduction; `driver` is the form of driver
/// file that renderers read, found by a dry run if the rule tries several.
std::vector<Implementation> find_candidates(const ExternalArguments& arguments,
                                            const std::optional<DriverRule>& driver = {});
/// The same, judged by stages, not by pictures. Errors: CandidateError for a renderer.
std::vector<Implementation> find_by_stages(const ExternalArguments& arguments);
/// The values of --rays and --intersect, of add_external, add_renderer and --dialect.
struct JudgedArguments {
  std::string rays;
  std::vector<std::string> intersect;
  ExternalArguments external;
  std::string dialect;

  bool name_methods() const { return !rays.empty() || !intersect.empty(); }
};
/// The pairs of methods that are named, if any, then the candidates.
std::vector<Implementation> find_judged(const JudgedArguments& arguments);
/// The methods of those names, each separately, then the candidates; without names, only the
/// candidates, if there are any.
std::vector<Implementation> find_by_stages(const std::vector<std::string>& methods,
                                           const ExternalArguments& arguments);

/// --format, one of these names; the first by default.
void add_format(CLI::App& command, std::string& format, const std::vector<std::string>& formats);
/// The same for views, or other named values.
template <class Named>
std::vector<std::string> names_of(const Named& all) {
  std::vector<std::string> names;
  for (const auto& one : all) names.emplace_back(one.name);
  return names;
}
void add_methods(CLI::App& command, std::vector<std::string>& methods);
/// Whether an option names files that are read.
bool reads(const CLI::Option& option);
/// Every text of an option that may name a file: the value, what follows "source:" or "name=", and
/// the words of a command.
std::vector<std::string> files_of(const CLI::Option& option);
/// The file that an option names, opened before the work whose result it takes; empty if it is not
/// given. Errors: std::invalid_argument as OutputFile.
std::optional<OutputFile> opened(const std::string& option, const std::optional<std::string>& path);
void add_top(CLI::App& command, std::size_t& top);
void add_max_ulp(CLI::App& command, std::optional<double>& bound, std::string_view meaning);
/// --view FILE: a page for a browser that shows `what`.
void add_view(CLI::App& command, std::optional<std::string>& path, std::string_view what);
void add_certificates(CLI::App& command, std::optional<std::string>& path);
/// --threads; `same`: the result that does not depend on it.
void add_threads(CLI::App& command, int& threads, std::string_view same);
void add_strict(CLI::App& command, bool& strict);
void add_seed(CLI::App& command, std::uint64_t& seed);

/// Prints a report in the format of this name.
/// Domain: a name that add_format accepts.
template <class Report, std::size_t N>
void print_view(const View<Report> (&views)[N], std::string_view format, const Report& report) {
  const bool colours = stdout_takes_colours();
  for (const View<Report>& view : views) {
    if (view.name != format) continue;
    print_report(view.render(report, {colours}), colours);
  }
}

/// `found`: a defect or another failure; `checked`: enough was judged to exclude one.
int exit_code(bool was_interrupted, bool found, bool checked);

}  // namespace raycheck::tools
