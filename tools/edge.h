#pragma once

// What the file of a command includes: the options that several commands have, how their values are
// read, and what they find; its row in commands.h; printing.

#include <tbb/info.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "properties/cases/case_source.h"
#include "scene/files/scene_file.h"
#include "scene/text.h"
#include "tools/commands.h"
#include "tools/external/locate.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/gates/gate.h"
#include "tools/implementations/built_in.h"
#include "tools/report/output_file.h"
#include "tools/shards/units.h"
#include "tools/terminal.h"

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
/// The format in which a file is to be read, from --dialect; null for an empty text and for `auto`:
/// then it is detected from the file.
const scene::FileFormat* parse_dialect(const std::string& text);
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

/// The source of cases of that name, SOURCE or SOURCE@SEVERITY. Errors: scene::InvalidInput.
properties::ChosenSource parse_source(const std::string& name);

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

/// The values of --out, --shard and, given by `merge`, --merged.
struct ShardArguments {
  const CLI::App* command = nullptr;
  std::string out, shard;
  std::vector<std::string> merged;
};
void add_shards(CLI::App& command, ShardArguments& arguments);
/// The same for a command whose --out also takes the results; `by_default`: the default shard.
void add_shards_inside(CLI::App& command, ShardArguments& arguments,
                       const std::string& by_default = "all");

/// Options that units do not depend on: the form of the report, threads, isolation of candidates.
/// `merge` takes them from its own command line, not from the campaign.
inline constexpr std::string_view kReportOptions[] = {
    "--format",          "--report",         "--view",   "--certificates", "--save",   "--top",
    "--threads",         "--jobs",           "--corpus", "--sandbox",      "--i-know", "--baseline",
    "--update-baseline", "--strict-baseline"};

/// Options that units depend on: a shard writes them into its folder, with the positional
/// arguments, and `merge` takes them from one.
inline constexpr std::string_view kUnitOptions[] = {
    "--filter",      "--cases",    "--seed",    "--rays",       "--source",       "--intersect",
    "--candidate",   "--declare",  "--read",    "--level",      "--include",      "--timeout",
    "--memory",      "--bounds",   "--target",  "--precision",  "--image-change", "--t-threshold",
    "--any-sample",  "--depth",    "--dialect", "--keep-going", "--max-ulp",      "--method",
    "--severity",    "--quantity", "--by",      "--steps",      "--searches",     "--pixels",
    "--secret-file", "--strict",   "--all"};

/// Those of both that have no value.
inline constexpr std::string_view kFlags[] = {"--i-know", "--update-baseline", "--strict-baseline",
                                              "--strict", "--all"};
/// Whether one of these options is `name`.
template <std::size_t N>
bool has(const std::string_view (&options)[N], std::string_view name) {
  return std::ranges::find(options, name) != std::end(options);
}

using Judged = std::span<const Implementation>;
/// The units selected by the options, reported on standard error; null: nothing is kept. They
/// depend on the sources of the judged candidates.
/// Domain: arguments of add_shards() that are parsed.
std::unique_ptr<Units> units_of(const ShardArguments& arguments, Judged judged = {});
/// Whether a campaign's report also runs candidates or submissions.
bool runs_candidates(const CampaignIdentity& campaign);
/// Reports on standard error that a shard is done; returns its exit code.
int shard_done(const ShardArguments& arguments, const Units& units, bool was_interrupted);

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
  bool any_sample = false;
  std::string depth;  ///< For depth_form(); empty: pictures show colours.
};
void add_external(CLI::App& command, ExternalArguments& arguments);
/// The same, and --precision, --image-change, --t-threshold, --any-sample and --depth.
void add_judged(CLI::App& command, ExternalArguments& arguments);
/// Compiles each candidate if necessary, and reads its introduction; `driver` is the form of driver
/// file that renderers read, found by a dry run if the rule tries several.
std::vector<Implementation> find_candidates(const ExternalArguments& arguments,
                                            const std::optional<DriverRule>& driver = {});
/// The same, judged by stages, not by pictures. Errors: CandidateError for a renderer.
std::vector<Implementation> find_by_stages(const ExternalArguments& arguments);
/// The values of options that several commands have.
struct CommonArguments {
  std::string dialect, format, rays;
  std::vector<std::string> intersect;
  ExternalArguments external;
  std::optional<std::string> view, certificates;
  int threads = tbb::info::default_concurrency();
  ShardArguments shards;
};
/// The pairs of methods that are named, if any, then the candidates.
std::vector<Implementation> find_judged(const CommonArguments& arguments);
/// The methods of those names, each separately, then the candidates; without names, only the
/// candidates, if there are any.
std::vector<Implementation> find_by_stages(const std::vector<std::string>& methods,
                                           const ExternalArguments& arguments);

/// The values of --format, --report, --baseline and related options.
struct GateArguments {
  std::string format;
  std::vector<std::string> reports;  ///< KIND=FILE
  std::string baseline;
  bool updates = false;
  bool strict = false;
};
/// --format and --report, of these names and those of gate_formats(), and the options of a
/// baseline.
void add_gate(CLI::App& command, GateArguments& arguments, std::vector<std::string> formats);

/// Prints a report, or its gate, in the format of this name.
template <class Report, std::size_t N>
void print_view(const View<Report> (&views)[N], std::string_view format, const Report& report,
                const Gate& gate) {
  print_view(views, format, report);
  for (const GateFormat& one : gate_formats()) {
    if (one.name != format) continue;
    one.is_executed ? print_commands(one.write(gate)) : print_report(one.write(gate));
  }
}

/// The files of a gate: opened before the work, so that hours are not lost, and written after it.
class GateFiles {
 public:
  /// Errors: std::invalid_argument naming the option, the file and what is wrong with it.
  explicit GateFiles(const GateArguments& arguments);

  /// The gate of a report, after its findings are compared with the baseline, if there is one,
  /// which is updated if requested.
  template <class Report>
  Gate compared(Report& report, Gate (*gate_of)(const Report&)) {
    Gate gate = gate_of(report);
    report.ratchet = ratchet(gate.findings, report.interrupted);
    return report.ratchet ? gate_of(report) : gate;
  }

  template <class Report, std::size_t N>
  void write(const View<Report> (&views)[N], const Report& report, const Gate& gate) {
    for (ReportFile& one : reports_) {
      for (const View<Report>& view : views) {
        if (view.name == one.kind) one.file->write(scene::visible(view.render(report, {})));
      }
      for (const GateFormat& format : gate_formats()) {
        if (format.name == one.kind) one.file->write(scene::visible(format.write(gate)));
      }
    }
  }

 private:
  struct ReportFile {
    std::string kind;
    std::unique_ptr<OutputFile> file;
  };
  std::optional<Ratchet> ratchet(const Findings& findings, bool was_interrupted);

  std::vector<ReportFile> reports_;
  std::string baseline_path_;
  Baseline baseline_;
  bool is_strict_ = false;
  std::optional<OutputFile> new_baseline_;
};

}  // namespace raycheck::tools
