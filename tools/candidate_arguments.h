#pragma once

// The arguments that name methods and candidates, and what they find. Internal to the commands.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/external/locate.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {

void add_methods(CLI::App& command, std::vector<std::string>& methods);
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

/// The values of --candidate and of the options that need it.
struct ExternalArguments {
  std::vector<std::string> candidates;
  std::vector<std::string> reads, includes;  ///< Folders to read; folders of headers.
  SandboxArguments sandbox;
  double seconds = Limits{}.seconds;
  std::uint64_t memory_mib = Limits{}.memory >> 20;
  std::string declares;  ///< Statements of a contract.
  std::string bounds;    ///< The methods whose bounds apply; empty: kDefaultMethods.
  scene::Precision precision = scene::Precision::kDouble;  ///< Of renderers.
  std::optional<double> image_change;                      ///< Empty: the precision's default.
  double threshold = 0;
  std::optional<scene::Origin> origin;  ///< Of renderers; empty: the scene's.
};
void add_external(CLI::App& command, ExternalArguments& arguments);
/// The same, and --precision, --image-change, --t-threshold and --origin.
void add_judged(CLI::App& command, ExternalArguments& arguments);
/// Compiles each candidate if necessary, and reads its introduction; `driver` is the form of driver
/// file that renderers read, found by a dry run if the rule tries several.
std::vector<Implementation> find_candidates(const ExternalArguments& arguments,
                                            const std::optional<DriverRule>& driver = {});
/// The same, judged by stages, not by pictures. Errors: CandidateError for a renderer.
std::vector<Implementation> find_by_stages(const ExternalArguments& arguments);
/// The values of --rays and --intersect, of add_judged and --dialect.
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

}  // namespace raycheck::tools
