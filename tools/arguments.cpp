#include "tools/arguments.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "scene/number.h"
#include "tools/command_line.h"

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

std::int64_t parse_index(const char* option, std::string_view text, std::int64_t least) {
  const auto number = scene::parse_number(text);
  if (!number || *number < static_cast<double>(least) || *number > 9e15 ||
      *number != static_cast<double>(static_cast<std::int64_t>(*number))) {
    throw std::invalid_argument(
        fmt::format("{} {}: give a whole number from {}", option, text, least));
  }
  return static_cast<std::int64_t>(*number);
}

std::optional<scene::Dialect> parse_dialect(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (text == "A" || text == "a") return scene::Dialect::kA;
  if (text == "B" || text == "b") return scene::Dialect::kB;
  if (text == "C" || text == "c") return scene::Dialect::kC;
  throw std::invalid_argument("--dialect " + text + ": the dialects are A, B, C");
}

const CLI::Validator kBound(
    [](std::string& text) -> std::string {
      const auto number = scene::parse_number(text);
      if (number && *number >= 0 && std::isfinite(*number)) return {};
      return "give a finite number from 0, not " + text;
    },
    "NUMBER", "bound");

std::vector<MethodPair> chosen_methods(const std::string& rays_name,
                                       const std::vector<std::string>& intersect) {
  const auto& rays = rays_name.empty() ? *kDefaultMethods.rays : find_rays(rays_name);
  std::vector<MethodPair> pairs;
  for (const std::string& name : intersect) {
    const MethodPair pair = {&rays, &find_intersect(name)};
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
  }
  if (pairs.empty()) pairs.push_back({&rays, kDefaultMethods.intersect});
  return pairs;
}

void add_sandbox(CLI::App& command, std::string& sandbox) {
  command
      .add_option("--sandbox", sandbox,
                  "how candidates are kept: auto, what works here; require, refuse without seccomp "
                  "and bubblewrap; none, limits only")
      ->check(CLI::IsMember({"auto", "require", "none"}))
      ->capture_default_str();
}

Sandbox sandbox_of(const std::string& text) {
  return text == "none" ? Sandbox::kNone : text == "require" ? Sandbox::kRequire : Sandbox::kAuto;
}

void add_external(CLI::App& command, ExternalArguments& arguments) {
  command.add_option("--candidate", arguments.candidates,
                     "someone else's implementation instead: library:PATH.so, source:PATH, "
                     "command:'WORDS' or renderer:'WORDS'; several times for several");
  add_sandbox(command, arguments.sandbox);
  command.add_option("--timeout", arguments.seconds, "seconds a candidate has for one reply")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--bounds", arguments.bounds,
                     "whose documented bounds hold for candidates: INTERSECT or RAYS/INTERSECT "
                     "(default: direct/cross)");
}

void add_renderer(CLI::App& command, ExternalArguments& arguments) {
  command
      .add_option("--image-change", arguments.image_change,
                  "relative changes of the scene that a renderer's picture may not show (1e-4 "
                  "where it computes in float)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      .add_option("--t-threshold", arguments.threshold,
                  "a renderer's hits with a parameter of at most this are not judged")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

std::vector<Contestant> find_contestants(const ExternalArguments& arguments,
                                         std::optional<scene::Dialect> dialect) {
  std::vector<Contestant> found;
  if (arguments.candidates.empty()) return found;
  RunOptions options;
  options.layers = chosen_layers(sandbox_of(arguments.sandbox));
  options.limits.seconds = arguments.seconds;
  if (!arguments.bounds.empty()) options.bounds = find_pair(arguments.bounds);
  options.dialect = dialect.value_or(options.dialect);
  options.excused_image_change = arguments.image_change;
  options.image_threshold = arguments.threshold;
  for (const std::string& what : arguments.candidates) {
    found.emplace_back(find_external(parse_candidate(what), options));
  }
  return found;
}

void add_format(CLI::App& command, std::string& format, const std::vector<std::string>& formats) {
  format = formats.front();
  std::string meaning;
  for (std::size_t k = 0; k < formats.size(); ++k) {
    meaning += (k == 0 ? "" : k + 1 == formats.size() ? " or " : ", ") + formats[k];
  }
  command.add_option("--format", format, meaning)
      ->check(CLI::IsMember(formats))
      ->capture_default_str();
}

void add_certificates(CLI::App& command, std::optional<std::string>& path) {
  command
      .add_option("--certificates", path,
                  "takes proofs of the discrepancies found; tools/verify_certificates.py confirms "
                  "them without raycheck")
      ->type_name("FILE");
}

void add_threads(CLI::App& command, int& threads, std::string_view same) {
  constexpr int kMostThreads = 1024;
  command.add_option("--threads", threads, fmt::format("how many; {} is the same", same))
      ->check(CLI::Range(1, kMostThreads))
      ->capture_default_str();
}

void add_strict(CLI::App& command, bool& strict) {
  command.add_flag("--strict", strict,
                   "fail, too, for what is excused by a witness or left undecided");
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
  command.add_option("--seed", seed, "the same seed gives the same cases")
      ->check(CLI::Range(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
}

void print_error(const std::string& text) { std::fputs(text.c_str(), stderr); }

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) print_error(fmt::format("warning: {}\n", warning));
}

void print_report(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw std::runtime_error(std::string("the report could not be written: ") +
                             std::strerror(errno));
  }
}

void draw_or_say(const std::vector<Plot>& plots, const std::string& path) {
  try {
    draw(plots, path);
  } catch (const GnuplotMissing& error) {
    print_error(fmt::format("warning: {}\n", error.what()));
  }
}

int exit_code(bool was_interrupted, bool found, bool checked) {
  if (was_interrupted) return kExitInterrupted;
  if (found) return kExitDiscrepancy;
  return checked ? kExitNothingFound : kExitNothingChecked;
}

}  // namespace raycheck::tools
