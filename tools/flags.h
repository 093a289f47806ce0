#pragma once

// Options that several commands have, and how their values are read. Internal to the commands.

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
#include "tools/external/pictures/driver_form.h"
#include "tools/report/output_file.h"

namespace raycheck::tools {

/// `count` numbers separated by commas; the error names the option and the text.
std::vector<double> parse_list(const char* option, std::string_view text, std::size_t count,
                               const char* meaning);
/// Doubles represent every whole number up to here.
inline constexpr std::int64_t kMostIndex = 9'000'000'000'000'000;
/// A whole number in this range; the error names the option, and `others`: what else is accepted.
std::int64_t parse_index(const char* option, std::string_view text, std::int64_t least,
                         std::int64_t most = kMostIndex, std::string_view others = "");
/// A pixel of a scene's camera, "I,J"; the error also names the scene's file.
scene::Pixel parse_pixel(const char* option, std::string_view text, std::string_view path,
                         const scene::Scene& scene);
/// How a file is to be read, from --dialect; nothing for an empty text.
scene::ReadAs parse_dialect(const std::string& text);
/// The driver form from --dialect, or the rule `auto` (each is tried); empty for an empty text.
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
/// An option that takes one of `names`, which are the enumeration's, in its order. A std::optional
/// value has no default.
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

/// --format, one of these names; the first by default.
void add_format(CLI::App& command, std::string& format, const std::vector<std::string>& formats);
/// The names of a table of views or of other named values, for add_format().
template <class Named>
std::vector<std::string> names_of(const Named& all) {
  std::vector<std::string> names;
  for (const auto& one : all) names.emplace_back(one.name);
  return names;
}
/// Whether an option names files that are read.
bool reads(const CLI::Option& option);
/// Every text of an option that may name a file: the value, what follows "source:" or "name=", and
/// the words of a command.
std::vector<std::string> files_of(const CLI::Option& option);
/// The file that an option names, opened before the work whose result it takes; empty if it is not
/// given. Errors: std::invalid_argument as OutputFile.
std::optional<OutputFile> opened(const std::string& option, const std::optional<std::string>& path);
void add_max_ulp(CLI::App& command, std::optional<double>& bound, std::string_view meaning);
/// --view FILE: a page for a browser that shows `what`.
void add_view(CLI::App& command, std::optional<std::string>& path, std::string_view what);
void add_certificates(CLI::App& command, std::optional<std::string>& path);
/// --threads; `same`: the result that does not depend on it.
void add_threads(CLI::App& command, int& threads, std::string_view same);
void add_strict(CLI::App& command, bool& strict);
void add_seed(CLI::App& command, std::uint64_t& seed);

}  // namespace raycheck::tools
