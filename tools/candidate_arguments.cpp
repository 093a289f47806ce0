#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "tools/edge.h"
#include "tools/external/pictures/dry_run.h"

namespace raycheck::tools {

void add_methods(CLI::App& command, std::vector<std::string>& methods) {
  command
      .add_option(
          "--method,--methods", methods,
          "only these methods, separated by commas, or all (default: all but reference; none if "
          "--candidate is given)")
      ->delimiter(',');
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
  return add_named(command, "--sandbox", arguments.sandbox, kSandboxNames,
                   "isolation of the judged programs; require: fail unless seccomp, bubblewrap "
                   "and, as root, a separate "
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
                         "your code to judge: library:PATH.so, source:PATH or command:'WORDS' "
                         "(check and properties: also renderer:'WORDS'); may be repeated");
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
      .add_option("--declare", arguments.declares,
                  "what candidates promise, as if their code declared it: NAME VALUE, separated by "
                  "semicolons (names: raycheck list)")
      ->needs(candidate);
  command
      .add_option("--bounds", arguments.bounds,
                  "the methods whose error bounds apply to candidates: INTERSECT or RAYS/INTERSECT "
                  "(default: direct/cross)")
      ->needs(candidate);
}

void add_judged(CLI::App& command, ExternalArguments& arguments) {
  add_external(command, arguments);
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
                  "excuse a renderer's wrong pixels if the exact s is at most this")
      ->check(kBound)
      ->needs(candidate)
      ->capture_default_str();
  command
      .add_flag("--any-sample", arguments.any_sample,
                "a renderer's pixel is right if some point of its square shows what it shows")
      ->needs(candidate);
  command
      .add_option(
          "--depth", arguments.depth,
          "a renderer writes depth pictures (PFM), whose numbers are: s along the ray's unit "
          "direction, distance from the eye, z along the view axis, or image-plane, z in "
          "multiples of |near|; then, if not inf, the number of a pixel without a sphere: 'z "
          "miss 0'")
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

/// Whether a compiler, a loader, Python or Node reports a missing file.
bool lacks_a_file(const CandidateError& error) {
  const std::string all = error.why() + error.output();
  const auto is_said = [&](const char* words) { return all.find(words) != std::string::npos; };
  return std::ranges::any_of(
      std::array{"No such file or directory", "cannot open shared object file", "No module named",
                 "Cannot find module", "Cannot find package"},
      is_said);
}

External located(const std::string& what, const RunOptions& options) {
  const CandidateSpec spec = parse_candidate(what);
  try {
    return find_external(spec, options);
  } catch (const CandidateError& error) {
    const bool hides_files = options.layers.bubblewrap || options.layers.landlock;
    if (!hides_files || !lacks_a_file(error)) throw;
    throw CandidateError(
        error.why() +
            "; a candidate can read only its own folder and the system's: add a folder by --read "
            "DIR, or a folder of headers by --include DIR",
        error.output(), spec.text());
  }
}

RunOptions run_options(const ExternalArguments& arguments) {
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
  options.precision = arguments.precision;
  options.excused_image_change =
      arguments.image_change.value_or(properties::excused_image_change(options.precision));
  options.image_threshold = arguments.threshold;
  options.any_sample = arguments.any_sample;
  try {
    if (!arguments.depth.empty()) options.depth = depth_form(arguments.depth);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("--depth '{}': {}", arguments.depth, error.what()));
  }
  return options;
}

}  // namespace

std::vector<Implementation> find_candidates(const ExternalArguments& arguments,
                                            const std::optional<DriverRule>& driver) {
  std::vector<Implementation> found;
  if (arguments.candidates.empty()) return found;
  RunOptions options = run_options(arguments);
  if (driver) options.driver = driver->form;
  for (const std::string& what : arguments.candidates) {
    External external = located(what, options);
    if (external.renderer && driver && driver->tries_others)
      external = as_it_reads(external, *driver);
    try {
      declare_over(arguments.declares, external);
    } catch (const std::invalid_argument& error) {
      throw CandidateError(fmt::format("--declare '{}': {}", arguments.declares, error.what()), {},
                           what);
    }
    found.push_back(implementation_of(external));
    found.back().number = all_intersect_methods().size() + found.size() - 1;
  }
  return found;
}

std::vector<Implementation> find_judged(const CommonArguments& arguments) {
  auto found = find_candidates(arguments.external, parse_driver(arguments.dialect));
  if (arguments.rays.empty() && arguments.intersect.empty()) return found;
  const auto methods = built_in(chosen_methods(arguments.rays, arguments.intersect));
  found.insert(found.begin(), methods.begin(), methods.end());
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
  std::vector<Implementation> found = find_by_stages(arguments);
  if (!found.empty() && methods.empty()) return found;
  const auto named = find_methods(methods);
  found.insert(found.begin(), named.begin(), named.end());
  return found;
}

}  // namespace raycheck::tools
