#include "tools/arguments.h"

#include <fmt/core.h>
#include <unistd.h>

#include <charconv>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "properties/verdict.h"
#include "scene/number.h"
#include "tools/commands.h"
#include "tools/external/pictures/dry_run.h"

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
                         std::int64_t most) {
  const auto number = scene::parse_number(text);
  if (!number || !(*number >= static_cast<double>(least) && *number <= static_cast<double>(most)) ||
      *number != static_cast<double>(static_cast<std::int64_t>(*number))) {
    throw std::invalid_argument(
        fmt::format("{} {}: give a whole number from {} to {}", option, text, least, most));
  }
  return static_cast<std::int64_t>(*number);
}

scene::Pixel parse_pixel(const char* option, std::string_view text) {
  const auto pixel = parse_list(option, text, 2, "column and row: I,J");
  return {parse_index(option, scene::shortest(pixel[0]), 0),
          parse_index(option, scene::shortest(pixel[1]), 0)};
}

scene::Pixel parse_pixel(const char* option, std::string_view text, std::string_view path,
                         const scene::Scene& scene) {
  const scene::Pixel pixel = parse_pixel(option, text);
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

std::optional<scene::Dialect> parse_dialect(const std::string& text) {
  const auto rule = parse_driver(text);
  // With `auto` the dialect is detected from the file.
  return rule && !rule->tries_others ? std::optional(rule->form.dialect) : std::nullopt;
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
      "the dialect of a driver file: A, B or C, or the year of a course, 2017 to 2020");
}

void add_rubric_dialect(CLI::App& command, std::string& dialect) {
  command.add_option(
      "--dialect", dialect,
      "the form of driver files for renderers, in place of the rubric's [driver]: A, "
      "B, C, 2017 to 2020, auto (the form that each one reads), or a form such as "
      "B:17:no-light");
}

properties::ChosenSource parse_source(std::string_view option, const std::string& name) {
  try {
    return properties::chosen_source(name);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("{} {}: {}; `raycheck list` shows the sources", option, name, error.what()));
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
  std::string meaning;
  for (std::size_t k = 0; k < formats.size(); ++k) {
    meaning += (k == 0 ? "" : k + 1 == formats.size() ? " or " : ", ") + formats[k];
  }
  command.add_option("--format", format, meaning)
      ->check(CLI::IsMember(formats))
      ->capture_default_str();
}

void add_methods(CLI::App& command, std::vector<std::string>& methods) {
  command
      .add_option("--method,--methods", methods,
                  "only these methods, separated by commas, or all (default: all but reference)")
      ->delimiter(',');
}

std::optional<OutputFile> opened(const std::string& option,
                                 const std::optional<std::string>& path) {
  if (!path) return std::nullopt;
  return std::optional<OutputFile>(std::in_place, option, *path);
}

void add_top(CLI::App& command, std::size_t& top) {
  add_number(command, "--top", top, 0, properties::kKeptDiscrepancies,
             "the number of worst discrepancies to show");
}

void add_max_ulp(CLI::App& command, std::optional<double>& bound, std::string_view meaning) {
  command.add_option("--max-ulp", bound, std::string(meaning))->check(kBound);
}

void add_view(CLI::App& command, std::optional<std::string>& path, std::string_view what) {
  command.add_option("--view", path, fmt::format("write a page for a browser that shows {}", what));
}

void add_certificates(CLI::App& command, std::optional<std::string>& path) {
  command
      .add_option("--certificates", path,
                  "write a proof of each discrepancy; tools/verify_certificates.py checks them "
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

int exit_code(bool was_interrupted, bool found, bool checked) {
  if (was_interrupted) return kExitOfSignal + caught_signal();
  if (found) return kExitDiscrepancy;
  return checked ? kExitNothingFound : kExitNothingChecked;
}

std::vector<MethodPair> chosen_methods(const std::string& rays_name,
                                       const std::vector<std::string>& intersect,
                                       const char* field) {
  const auto& rays = rays_name.empty() ? *kDefaultMethods.rays : find_rays(rays_name);
  std::vector<MethodPair> pairs;
  for (const std::string& name : intersect) {
    const MethodPair pair = {&rays, &find_intersect(name, field)};
    if (std::ranges::find(pairs, pair) == pairs.end()) pairs.push_back(pair);
  }
  if (pairs.empty()) pairs.push_back({&rays, kDefaultMethods.intersect});
  return pairs;
}

CLI::Option* add_sandbox(CLI::App& command, SandboxArguments& arguments) {
  command.add_flag("--i-know", arguments.knows,
                   "allow --sandbox none as root: candidates can then do anything that root can");
  constexpr std::array<std::string_view, 3> kSandboxNames = {"require", "available", "none"};
  return add_named(
      command, "--sandbox", arguments.sandbox, kSandboxNames,
      "isolation of candidates; require: fail unless seccomp, bubblewrap and, as root, a separate "
      "user work; available: use what works here; none: only limits");
}

Sandbox sandbox_of(const SandboxArguments& arguments) {
  if (arguments.sandbox == Sandbox::kNone && geteuid() == 0 && !arguments.knows) {
    throw std::invalid_argument(
        "--sandbox none: candidates would run as root, and could do anything that root can; run "
        "raycheck as another user, or give --i-know");
  }
  return arguments.sandbox;
}

void add_external(CLI::App& command, ExternalArguments& arguments) {
  // Less is too short for any answer; more than a day is practically unlimited.
  constexpr double kLeastSeconds = 1e-3, kMostSeconds = 86400;
  CLI::Option* const candidate =
      command.add_option("--candidate", arguments.candidates,
                         "the code to judge instead of raycheck's methods: library:PATH.so, "
                         "source:PATH or command:'WORDS' (check and properties: also "
                         "renderer:'WORDS'); may be repeated");
  add_sandbox(command, arguments.sandbox)->needs(candidate);
  command
      .add_option("--read", arguments.reads,
                  "a folder that candidates may read, besides their own and the system's folders")
      ->needs(candidate)
      ->check(CLI::ExistingDirectory);
  command
      .add_option("--include", arguments.includes,
                  "a folder of headers for source:PATH; candidates may read it")
      ->needs(candidate)
      ->check(CLI::ExistingDirectory);
  command
      .add_option("--timeout", arguments.seconds,
                  "the CPU seconds that a candidate may take for one reply")
      ->check(number_between(kLeastSeconds, kMostSeconds))
      ->needs(candidate)
      ->capture_default_str();
  add_number(
      command, "--memory", arguments.memory_mib, 1, std::uint64_t{1} << 30,
      "the MiB of memory that a candidate may use, and that each of its processes may reserve")
      ->needs(candidate);
  command
      .add_option("--bounds", arguments.bounds,
                  "the methods whose error bounds apply to candidates: INTERSECT or RAYS/INTERSECT "
                  "(default: direct/cross)")
      ->needs(candidate);
}

void add_renderer(CLI::App& command, ExternalArguments& arguments) {
  CLI::Option* const candidate = command.get_option("--candidate");
  add_named(command, "--precision", arguments.precision, scene::kPrecisionNames,
            "precision of renderers: double; or single if they compute in float: their scenes are "
            "rounded to floats. Other candidates declare their precision")
      ->needs(candidate);
  command
      .add_option(
          "--image-change", arguments.image_change,
          "a renderer's wrong pixel is excused if a relative change of the scene by at most "
          "this makes it right (default: 1e-6, with --precision single 1e-4)")
      ->check(number_between(0, 1))
      ->needs(candidate);
  command
      .add_option("--t-threshold", arguments.threshold,
                  "excuse wrong pixels of a renderer whose exact parameter is at most this")
      ->check(kBound)
      ->needs(candidate)
      ->capture_default_str();
  add_named(command, "--origin", arguments.origin, scene::kOriginNames,
            "where the rays of a renderer start (default: where the scene says)")
      ->needs(candidate);
}

namespace {

/// A renderer, given driver files of the form that it reads.
External as_it_reads(const External& external, const DriverRule& rule) {
  const DryRun found = dry_run(*external.renderer, rule);
  if (found.refusal) throw CandidateError(found.refusal->why, {}, external.name);
  External reader = external;
  reader.renderer->colours = found.colours;
  return reading(reader, found.driver);
}

/// How to let a candidate read a file that it reports as missing.
std::string hint_of_missing(const CandidateError& error, const Layers& layers) {
  if (!layers.bubblewrap && !layers.landlock) return "";
  const std::string all = error.why() + error.said();
  // Of compilers and loaders, of Python and of Node.
  for (const char* words : {"No such file or directory", "cannot open shared object file",
                            "No module named", "Cannot find module", "Cannot find package"}) {
    if (all.find(words) == std::string::npos) continue;
    return "; a candidate can read only its own folder and the system's: add a folder by --read "
           "DIR, "
           "or a folder of headers by --include DIR";
  }
  return "";
}

External located(const std::string& what, const RunOptions& options) {
  const CandidateSpec spec = parse_candidate(what);
  try {
    return find_external(spec, options);
  } catch (const CandidateError& error) {
    const std::string hint = hint_of_missing(error, options.layers);
    if (hint.empty()) throw;
    throw CandidateError(error.why() + hint, error.said(), spec.text());
  }
}

}  // namespace

std::vector<Implementation> find_candidates(const ExternalArguments& arguments,
                                            const std::optional<DriverRule>& driver) {
  std::vector<Implementation> found;
  if (arguments.candidates.empty()) return found;
  RunOptions options;
  options.layers = chosen_layers(sandbox_of(arguments.sandbox)).layers;
  options.limits.seconds = arguments.seconds;
  options.limits.memory = arguments.memory_mib << 20;
  options.limits.names.memory = "--memory";
  const auto canonical = [](const std::vector<std::string>& folders) {
    std::vector<std::filesystem::path> paths;
    for (const std::string& one : folders) paths.push_back(std::filesystem::canonical(one));
    return paths;
  };
  options.includes = canonical(arguments.includes);
  options.reads = canonical(arguments.reads);
  if (!arguments.bounds.empty()) options.bounds = find_pair(arguments.bounds);
  if (driver) options.driver = driver->form;
  options.precision = arguments.precision;
  options.excused_image_change =
      arguments.image_change.value_or(properties::excused_image_change(options.precision));
  options.image_threshold = arguments.threshold;
  options.origin = arguments.origin;
  for (const std::string& what : arguments.candidates) {
    External external = located(what, options);
    if (external.renderer && driver && driver->tries_others)
      external = as_it_reads(external, *driver);
    found.push_back(implementation_of(external));
    found.back().number = all_intersect_methods().size() + found.size() - 1;
  }
  return found;
}

std::vector<Implementation> find_judged(const JudgedArguments& arguments) {
  std::vector<Implementation> found;
  const auto others = find_candidates(arguments.external, parse_driver(arguments.dialect));
  if (arguments.name_methods()) {
    found = built_in(chosen_methods(arguments.rays, arguments.intersect));
  }
  found.insert(found.end(), others.begin(), others.end());
  return found;
}

std::vector<Implementation> find_by_stages(const ExternalArguments& arguments) {
  std::vector<Implementation> found = find_candidates(arguments);
  for (const Implementation& one : found) {
    if (!one.stages.empty()) continue;
    throw CandidateError(
        one.draws() ? "it only draws pictures; this command judges single answers"
                    : "it has none of the functions pixel_ray(), focal_ray() and intersect()",
        {}, one.name);
  }
  return found;
}

std::vector<Implementation> find_by_stages(const std::vector<std::string>& methods,
                                           const ExternalArguments& arguments) {
  const std::vector<Implementation> candidates = find_by_stages(arguments);
  std::vector<Implementation> found;
  if (candidates.empty() || !methods.empty()) found = find_methods(methods);
  found.insert(found.end(), candidates.begin(), candidates.end());
  return found;
}

}  // namespace raycheck::tools
