#include "tools/command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/number.h"
#include "scene/scene_file.h"
#include "scene/validate.h"
#include "tools/check.h"
#include "tools/explain.h"
#include "tools/list.h"
#include "tools/output_file.h"
#include "tools/properties_command.h"
#include "tools/terminal.h"
#include "tools/version.h"

namespace raycheck::tools {
namespace {

/// Every option as it was given; commands take what is theirs.
struct Arguments {
  std::string scene;
  std::string dialect;
  std::string rays;
  std::vector<std::string> intersect;
  bool all = false;
  std::string pixels = "all";
  std::size_t top = 10;
  std::optional<double> max_ulp;
  std::optional<std::string> certificates;
  std::string format = "text";
  std::string filter;
  int cases = 100;
  std::uint64_t seed = 1;
  std::string replay;
  std::vector<std::string> sources;
  std::string pixel;
  std::string sphere;
  std::string ray;
};

/// `count` numbers separated by commas; the error names the option and the text.
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

/// A bound on errors: a number >= 0.
const CLI::Validator kBound(
    [](std::string& text) -> std::string {
      const auto number = scene::parse_number(text);
      if (number && *number >= 0 && std::isfinite(*number)) return {};
      return "give a finite number from 0, not " + text;
    },
    "NUMBER", "bound");

/// The pairs of methods asked for by --rays and --intersect.
std::vector<MethodPair> chosen_methods(const Arguments& arguments) {
  const auto& rays = arguments.rays.empty() ? *kDefaultMethods.rays : find_rays(arguments.rays);
  std::vector<MethodPair> pairs;
  for (const std::string& name : arguments.intersect) {
    const MethodPair pair = {&rays, &find_intersect(name)};
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
  }
  if (pairs.empty()) pairs.push_back({&rays, kDefaultMethods.intersect});
  return pairs;
}

/// Standard error may be closed or full; that is no reason to lose the report.
void print_error(const std::string& text) { std::fputs(text.c_str(), stderr); }

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) print_error(fmt::format("warning: {}\n", warning));
}

/// Throws when the report could not be written: a lost report must not look like a good one.
void print_report(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw std::runtime_error(std::string("the report could not be written: ") +
                             std::strerror(errno));
  }
}

int exit_code(bool was_interrupted, bool found, bool checked) {
  if (was_interrupted) return kExitInterrupted;
  if (found) return kExitDiscrepancy;
  return checked ? kExitNothingFound : kExitNothingChecked;
}

int run_check(const Arguments& arguments) {
  catch_interrupts();
  CheckOptions options;
  options.path = arguments.scene;
  options.dialect = parse_dialect(arguments.dialect);
  if (arguments.all && !(arguments.rays.empty() && arguments.intersect.empty())) {
    throw std::invalid_argument("--all: judges every method; leave out --rays and --intersect");
  }
  options.methods = arguments.all ? all_pairs() : chosen_methods(arguments);
  if (arguments.pixels != "all") options.pixels = parse_index("--pixels", arguments.pixels, 1);
  options.top = arguments.top;
  options.max_error = arguments.max_ulp;
  std::optional<OutputFile> certificates;
  if (arguments.certificates) certificates.emplace("--certificates", *arguments.certificates);
  const CheckReport report = check(options);
  print_warnings(report.warnings);
  print_report(arguments.format == "json" ? check_json(report)
                                          : check_text(report, stdout_takes_colours()));
  if (certificates) certificates->write(check_certificates(report));
  return exit_code(report.interrupted, report.discrepancies() > 0, report.compared() > 0);
}

int run_properties_command(const Arguments& arguments) {
  catch_interrupts();
  if (!arguments.replay.empty() && !(arguments.filter.empty() && arguments.sources.empty() &&
                                     arguments.rays.empty() && arguments.intersect.empty())) {
    throw std::invalid_argument(
        "--replay: names its law, methods and source; leave out --filter, --source, --rays, "
        "--intersect");
  }
  PropertiesOptions options;
  options.filter = arguments.filter;
  options.cases = arguments.cases;
  options.seed = arguments.seed;
  options.replay = arguments.replay;
  options.sources = arguments.sources;
  options.max_error = arguments.max_ulp;
  if (!arguments.rays.empty() || !arguments.intersect.empty()) {
    options.methods = chosen_methods(arguments);
  }
  const PropertiesReport report = run_properties(options);
  print_report(arguments.format == "json" ? properties_json(report)
                                          : properties_text(report, stdout_takes_colours()));
  return exit_code(report.interrupted, report.failures() > 0, report.compared() > 0);
}

ExplainOptions explain_given_ray(const Arguments& arguments) {
  if (!(arguments.scene.empty() && arguments.pixel.empty() && arguments.rays.empty() &&
        arguments.dialect.empty())) {
    throw std::invalid_argument(
        "--ray: explains a ray given by numbers; leave out SCENE, --pixel, --rays, --dialect");
  }
  if (arguments.sphere.empty()) {
    throw std::invalid_argument("--ray: give the sphere too, --sphere cx,cy,cz,r");
  }
  const auto ray = parse_list("--ray", arguments.ray, 6, "origin and direction: ox,oy,oz,dx,dy,dz");
  const auto sphere = parse_list("--sphere", arguments.sphere, 4, "centre and radius: cx,cy,cz,r");
  ExplainOptions options;
  options.scene.rays = {{{ray[0], ray[1], ray[2]}, {ray[3], ray[4], ray[5]}}};
  options.scene.spheres = {{{sphere[0], sphere[1], sphere[2]}, sphere[3]}};
  return options;
}

ExplainOptions explain_pixel(const Arguments& arguments) {
  if (arguments.scene.empty() || arguments.pixel.empty()) {
    throw std::invalid_argument(
        "explain: give a scene and --pixel I,J, or --ray ox,oy,oz,dx,dy,dz and --sphere "
        "cx,cy,cz,r");
  }
  ExplainOptions options;
  auto loaded = scene::load_scene(arguments.scene, parse_dialect(arguments.dialect));
  print_warnings(loaded.warnings);
  options.scene = std::move(loaded.scene);
  if (!options.scene.camera) {
    throw std::invalid_argument(arguments.scene +
                                ": has given rays and no camera, so no pixels; explain one of "
                                "its rays by --ray and --sphere");
  }
  const auto pixel = parse_list("--pixel", arguments.pixel, 2, "column and row: I,J");
  options.pixel = scene::Pixel{parse_index("--pixel", scene::shortest(pixel[0]), 0),
                               parse_index("--pixel", scene::shortest(pixel[1]), 0)};
  if (!arguments.sphere.empty()) {
    options.sphere = static_cast<std::size_t>(parse_index("--sphere", arguments.sphere, 0));
  }
  if (!arguments.rays.empty()) options.rays = &find_rays(arguments.rays);
  return options;
}

int run_explain(const Arguments& arguments) {
  const ExplainReport report =
      explain(arguments.ray.empty() ? explain_pixel(arguments) : explain_given_ray(arguments));
  print_report(arguments.format == "json" ? explain_json(report)
                                          : explain_text(report, stdout_takes_colours()));
  return exit_code(false, report.has_discrepancy(), true);
}

int run_list(const Arguments& arguments) {
  print_report(arguments.format == "json" ? list_json() : list_text());
  return kExitNothingFound;
}

void add_format(CLI::App& command, Arguments& arguments) {
  command.add_option("--format", arguments.format, "text or json")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
}

void add_check(CLI::App& app, Arguments& arguments) {
  CLI::App& command = *app.add_subcommand("check", "Judge methods on every pixel of a scene");
  command.add_option("SCENE", arguments.scene, "a TOML scene, or a driver file of the course")
      ->required();
  command.add_option("--dialect", arguments.dialect, "of a driver file: A, B or C");
  command.add_option("--rays", arguments.rays, "the method that makes rays (default: direct)");
  command.add_option("--intersect", arguments.intersect,
                     "the method that intersects them, several times for several (default: cross)");
  command.add_flag("--all", arguments.all, "every pair of methods");
  command.add_option("--pixels", arguments.pixels, "all, or how many, spread evenly")
      ->capture_default_str();
  command.add_option("--top", arguments.top, "how many of the worst discrepancies are shown")
      ->check(CLI::Range(std::size_t{0}, properties::kKeptDiscrepancies))
      ->capture_default_str();
  command
      .add_option("--max-ulp", arguments.max_ulp,
                  "errors above are discrepancies (default: the method's documented bound)")
      ->check(kBound);
  command
      .add_option("--certificates", arguments.certificates,
                  "takes a proof of each discrepancy shown; tools/verify_certificates.py confirms "
                  "them without raycheck")
      ->type_name("FILE");
  add_format(command, arguments);
}

void add_properties(CLI::App& app, Arguments& arguments) {
  CLI::App& command =
      *app.add_subcommand("properties", "Try the laws on random cases, shrinking what breaks them");
  command.add_option("--filter", arguments.filter, "laws whose name contains this");
  command.add_option("--cases", arguments.cases, "cases for each law and candidate")
      ->check(CLI::Range(1, 1000000000))
      ->capture_default_str();
  command.add_option("--seed", arguments.seed, "the same seed gives the same cases")
      ->check(CLI::Range(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command.add_option("--replay", arguments.replay, "the string that a failure printed");
  command.add_option("--rays", arguments.rays, "only this method of making rays");
  command.add_option("--intersect", arguments.intersect,
                     "only this intersection method; several "
                     "times for several");
  command.add_option("--source", arguments.sources,
                     "only cases of this source; several times for "
                     "several");
  command
      .add_option("--max-ulp", arguments.max_ulp,
                  "the bound on every error (default: the method's documented bounds)")
      ->check(kBound);
  add_format(command, arguments);
}

void add_explain(CLI::App& app, Arguments& arguments) {
  CLI::App& command =
      *app.add_subcommand("explain", "Derive one ray step by step, exactly and by every method");
  command.add_option("SCENE", arguments.scene, "a scene with a camera");
  command.add_option("--dialect", arguments.dialect, "of a driver file: A, B or C");
  command.add_option("--pixel", arguments.pixel, "the pixel, I,J");
  command.add_option("--rays", arguments.rays,
                     "whose ray the intersection methods get (default: direct)");
  command.add_option("--ray", arguments.ray, "a ray instead: ox,oy,oz,dx,dy,dz");
  command.add_option("--sphere", arguments.sphere,
                     "which sphere of the scene (default: the one met first); with --ray: "
                     "cx,cy,cz,r");
  add_format(command, arguments);
}

}  // namespace

int run_command_line(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{"raycheck: an exact reference for camera rays and ray-sphere intersections"};
  app.set_version_flag("--version", std::string(kVersion));
  app.require_subcommand(1);
  add_check(app, arguments);
  add_properties(app, arguments);
  add_explain(app, arguments);
  add_format(*app.add_subcommand("list", "Show methods, laws, sources and conventions"), arguments);
  const std::string first = argc > 1 ? argv[1] : "";
  const auto is_first = [&](const CLI::App* command) { return command->get_name() == first; };
  const auto commands = app.get_subcommands({});
  if (!first.empty() && first.front() != '-' &&
      std::none_of(commands.begin(), commands.end(), is_first)) {
    print_error(fmt::format(
        "raycheck: there is no command '{}'; the commands are check, properties, explain, "
        "list\n",
        first));
    return kExitBadInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitNothingFound : kExitBadInput;
  }
  try {
    const std::string command = app.get_subcommands().front()->get_name();
    if (command == "check") return run_check(arguments);
    if (command == "properties") return run_properties_command(arguments);
    if (command == "explain") return run_explain(arguments);
    return run_list(arguments);
  } catch (const std::exception& error) {
    print_error(fmt::format("raycheck: {}\n", error.what()));
    return kExitBadInput;
  }
}

}  // namespace raycheck::tools
