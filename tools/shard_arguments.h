#pragma once

// The arguments of commands whose work is done in units, which may be kept, shared and merged.
// Internal to the commands.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/implementations/implementation.h"
#include "tools/shards/units.h"

namespace raycheck::tools {

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
    "--filter",    "--cases",   "--seed",       "--rays",      "--source",       "--intersect",
    "--candidate", "--declare", "--read",       "--level",     "--include",      "--timeout",
    "--memory",    "--bounds",  "--target",     "--precision", "--image-change", "--t-threshold",
    "--origin",    "--dialect", "--keep-going", "--max-ulp",   "--method",       "--severity",
    "--quantity",  "--by",      "--steps",      "--searches",  "--pixels",       "--secret-file",
    "--strict",    "--all"};

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

}  // namespace raycheck::tools
