#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "scene/invalid_input.h"
#include "scene/number.h"
#include "tools/edge.h"

namespace raycheck::tools {

std::vector<double> parse_list(const char* option, std::string_view text, std::size_t count,
                               const char* meaning) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string_view part = text.substr(at, end - at);
    const auto number = scene::parse_number(part);
    if (!number) {
      throw std::invalid_argument(fmt::format("{} {}: '{}' is not a number", option, text, part));
    }
    numbers.push_back(*number);
    at = end + 1;
  }
  if (numbers.size() != count) {
    throw std::invalid_argument(
        fmt::format("{} {}: give {} numbers, {}", option, text, count, meaning));
  }
  return numbers;
}

std::int64_t parse_index(const char* option, std::string_view text, std::int64_t least,
                         std::int64_t most, std::string_view others) {
  const auto number = scene::parse_number(text);
  if (!number || !(*number >= static_cast<double>(least) && *number <= static_cast<double>(most)) ||
      *number != static_cast<double>(static_cast<std::int64_t>(*number))) {
    throw std::invalid_argument(fmt::format("{} {}: give {}a whole number from {} to {}", option,
                                            text, others, least, most));
  }
  return static_cast<std::int64_t>(*number);
}

scene::Pixel parse_pixel(const char* option, std::string_view text, std::string_view path,
                         const scene::Scene& scene) {
  const auto at = parse_list(option, text, 2, "column and row: I,J");
  const scene::Pixel pixel = {parse_index(option, scene::shortest(at[0]), 0),
                              parse_index(option, scene::shortest(at[1]), 0)};
  if (!scene.camera) {
    throw std::invalid_argument(fmt::format(
        "{} {}: {} has rays instead of a camera, so it has no pixels", option, text, path));
  }
  const scene::Camera& camera = *scene.camera;
  if (pixel.i >= camera.width || pixel.j >= camera.height) {
    throw std::invalid_argument(fmt::format(
        "{} {}: {} has {} x {} pixels; give a column up to {} and a row up to {}", option, text,
        path, camera.width, camera.height, camera.width - 1, camera.height - 1));
  }
  return pixel;
}

const scene::FileFormat* parse_dialect(const std::string& text) {
  const auto rule = parse_driver(text);
  return rule && rule->is_asked_for ? rule->form.format : nullptr;
}

std::optional<DriverRule> parse_driver(const std::string& text) {
  if (text.empty()) return std::nullopt;
  try {
    return driver_rule(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("--dialect {}: {}", text, error.what()));
  }
}

void add_dialect(CLI::App& command, std::string& dialect) {
  command.add_option(
      "--dialect", dialect,
      "the format of the scene file: A, B or C, or the year of a course, 2017 to 2020, "
      "for driver files; a format such as nff; or a file FORMAT.toml");
}

void add_rubric_dialect(CLI::App& command, std::string& dialect) {
  command.add_option("--dialect", dialect,
                     "the form of scene files for renderers, in place of the rubric's [driver]: A, "
                     "B, C, 2017 to 2020, auto (the form that each one reads), a form such as "
                     "B:17:no-light, the name of a format such as nff, or a file FORMAT.toml");
}

properties::ChosenSource parse_source(const std::string& name) {
  try {
    return properties::chosen_source(name);
  } catch (const std::invalid_argument& error) {
    throw scene::InvalidInput("source", name,
                              fmt::format("{}; `raycheck list` shows the sources", error.what()));
  }
}

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  return {[least, most](std::string& text) -> std::string {
            const std::string_view digits = std::string_view(text).substr(text.starts_with('+'));
            std::uint64_t value = 0;
            const char* const end = digits.data() + digits.size();
            const auto read = std::from_chars(digits.data(), end, value);
            // The option parser would read digits after a leading 0 as octal.
            const bool is_decimal = digits.size() == 1 || !digits.starts_with('0');
            if (read.ec == std::errc{} && read.ptr == end && is_decimal && value >= least &&
                value <= most) {
              return {};
            }
            return fmt::format("give a whole number from {} to {}, not '{}'", least, most, text);
          },
          fmt::format("[{} - {}]", least, most), "whole number"};
}

CLI::Validator number_between(double least, double most) {
  return {[least, most](std::string& text) -> std::string {
            const auto number = scene::parse_number(text);
            if (number && *number >= least && *number <= most) return {};
            const std::string range = most < std::numeric_limits<double>::max()
                                          ? fmt::format("number from {} to {}", least, most)
                                          : fmt::format("finite number >= {}", least);
            return fmt::format("give a {}, not '{}'", range, text);
          },
          "", "number"};
}

const CLI::Validator kBound = number_between(0, std::numeric_limits<double>::max());

const CLI::Validator kGiven(
    [](std::string& text) -> std::string {
      return text.empty() ? "the value is empty; give one, or leave the option out" : "";
    },
    "", "given");

void add_format(CLI::App& command, std::string& format, const std::vector<std::string>& formats) {
  format = formats.front();
  const auto last = formats.end() - 1;
  command
      .add_option("--format", format,
                  fmt::format("{} or {}", fmt::join(formats.begin(), last, ", "), *last))
      ->check(CLI::IsMember(formats))
      ->capture_default_str();
}

std::optional<OutputFile> opened(const std::string& option,
                                 const std::optional<std::string>& path) {
  if (!path) return std::nullopt;
  return std::optional<OutputFile>(std::in_place, option, *path);
}

void add_max_ulp(CLI::App& command, std::optional<double>& bound, std::string_view meaning) {
  command.add_option("--max-ulp", bound, std::string(meaning))->check(kBound);
}

void add_view(CLI::App& command, std::optional<std::string>& path, std::string_view what) {
  command.add_option("--view", path, fmt::format("write a page for a browser that shows {}", what));
}

void add_certificates(CLI::App& command, std::optional<std::string>& path) {
  command
      .add_option(
          "--certificates", path,
          "write proofs of the worst discrepancies; tools/verify_certificates.py checks them "
          "without raycheck")
      ->type_name("FILE");
}

namespace {

/// Options whose value is a file to read, besides positional arguments.
constexpr const char* kReading[] = {"--baseline", "--candidate", "--secret-file", "--include",
                                    "--read"};

}  // namespace

bool reads(const CLI::Option& option) {
  return option.get_positional() ||
         std::ranges::any_of(kReading, [&](const char* name) { return option.check_name(name); });
}

std::vector<std::string> files_of(const CLI::Option& option) {
  std::vector<std::string> files;
  for (const std::string& value : option.results()) {
    for (const std::size_t begin : {std::size_t{0}, value.find(':') + 1, value.find('=') + 1}) {
      files.push_back(value.substr(begin));
      std::istringstream words(files.back());
      for (std::string word; words >> word;) files.push_back(word);
    }
  }
  return files;
}

void add_threads(CLI::App& command, int& threads, std::string_view same) {
  constexpr int kMostThreads = 1024;
  add_number(command, "--threads", threads, 1, kMostThreads,
             fmt::format("the number of threads; {} is the same for any number", same));
}

void add_strict(CLI::App& command, bool& strict) {
  command.add_flag("--strict", strict, "also fail for answers that are excused or undecided");
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
  add_number(command, "--seed", seed, 0, std::numeric_limits<std::uint64_t>::max(),
             "the same seed gives the same cases");
}

}  // namespace raycheck::tools
