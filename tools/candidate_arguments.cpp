#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "tools/arguments.h"
#include "tools/external/pictures/dry_run.h"

namespace raycheck::tools {

std::vector<MethodPair> chosen_methods(const std::string& rays_name,
                                       const std::vector<std::string>& intersect,
                                       const char* field) {
  const auto& rays = rays_name.empty() ? *kDefaultMethods.rays : find_rays(rays_name);
  std::vector<MethodPair> pairs;
  for (const std::string& name : intersect) {
    const MethodPair pair = {&rays, &find_intersect(name, field)};
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
  }
  if (pairs.empty()) pairs.push_back({&rays, kDefaultMethods.intersect});
  return pairs;
}

CLI::Option* add_sandbox(CLI::App& command, SandboxArguments& arguments) {
  command.add_flag("--i-know", arguments.knows,
                   "run candidates as root with --sandbox none: they may do whatever root may");
  constexpr std::array<std::string_view, 3> kSandboxNames = {"require", "available", "none"};
  return add_named(
      command, "--sandbox", arguments.sandbox, kSandboxNames,
      "isolation of candidates: require, refuse where seccomp, bubblewrap or, as root, a user of "
      "its own does not work; available, what works here; none, limits only");
}

Sandbox sandbox_of(const SandboxArguments& arguments) {
  if (arguments.sandbox == Sandbox::kNone && geteuid() == 0 && !arguments.knows) {
    throw std::invalid_argument(
        "--sandbox none: candidates would run as root, and may then do whatever root may; run "
        "raycheck as another user, or give --i-know");
  }
  return arguments.sandbox;
}

void add_external(CLI::App& command, ExternalArguments& arguments) {
  // Less time leaves none for an answer, more is no limit.
  constexpr double kLeastSeconds = 1e-3, kMostSeconds = 86400;
  CLI::Option* const candidate =
      command.add_option("--candidate", arguments.candidates,
                         "someone else's implementation instead: library:PATH.so, source:PATH, "
                         "command:'WORDS' or renderer:'WORDS'; several times for several");
  add_sandbox(command, arguments.sandbox)->needs(candidate);
  command
      .add_option("--timeout", arguments.seconds,
                  "seconds of CPU time a candidate has for one reply")
      ->check(number_between(kLeastSeconds, kMostSeconds))
      ->needs(candidate)
      ->capture_default_str();
  command
      .add_option("--bounds", arguments.bounds,
                  "whose documented bounds hold for candidates: INTERSECT or RAYS/INTERSECT "
                  "(default: direct/cross)")
      ->needs(candidate);
}

void add_renderer(CLI::App& command, ExternalArguments& arguments) {
  CLI::Option* const candidate = command.get_option("--candidate");
  add_named(command, "--precision", arguments.precision, scene::kPrecisionNames,
            "of renderers: double, or single: it computes in float, and is given scenes of floats; "
            "other candidates say themselves which")
      ->needs(candidate);
  command
      .add_option("--image-change", arguments.image_change,
                  "relative changes of the scene that a renderer's picture may not show (default: "
                  "1e-6, with --precision single 1e-4)")
      ->check(number_between(0, 1))
      ->needs(candidate);
  command
      .add_option("--t-threshold", arguments.threshold,
                  "a renderer's hits with a parameter of at most this are not judged")
      ->check(kBound)
      ->needs(candidate)
      ->capture_default_str();
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

}  // namespace

std::vector<Implementation> find_candidates(const ExternalArguments& arguments,
                                            const std::optional<DriverRule>& driver) {
  std::vector<Implementation> found;
  if (arguments.candidates.empty()) return found;
  RunOptions options;
  options.layers = chosen_layers(sandbox_of(arguments.sandbox)).layers;
  options.limits.seconds = arguments.seconds;
  if (!arguments.bounds.empty()) options.bounds = find_pair(arguments.bounds);
  if (driver) options.driver = driver->form;
  options.precision = arguments.precision;
  options.excused_image_change =
      arguments.image_change.value_or(properties::excused_image_change(options.precision));
  options.image_threshold = arguments.threshold;
  for (const std::string& what : arguments.candidates) {
    External external = find_external(parse_candidate(what), options);
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
    throw CandidateError(one.draws() ? "it draws pictures; this command asks for single answers"
                                     : "it makes no rays and intersects nothing",
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
