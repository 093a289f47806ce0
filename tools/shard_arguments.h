#pragma once

// The arguments of commands whose work is done in units, which may be kept, shared and merged.
// Internal to the commands.

#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string>
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

struct NamedOption {
  const char* name;
  bool has_value;
};
/// Options that units do not depend on: the form of the report, threads, isolation of candidates.
/// `merge` takes them from its own command line, not from the campaign.
inline constexpr NamedOption kReportOptions[] = {{"--format", true},
                                                 {"--report", true},
                                                 {"--view", true},
                                                 {"--certificates", true},
                                                 {"--save", true},
                                                 {"--top", true},
                                                 {"--threads", true},
                                                 {"--jobs", true},
                                                 {"--corpus", true},
                                                 {"--sandbox", true},
                                                 {"--i-know", false},
                                                 {"--baseline", true},
                                                 {"--update-baseline", false},
                                                 {"--strict-baseline", false}};

/// Options that units depend on: a shard writes them into its folder, with the positional
/// arguments, and `merge` takes them from one.
inline constexpr NamedOption kUnitOptions[] = {
    {"--filter", true},       {"--cases", true},       {"--seed", true},
    {"--rays", true},         {"--source", true},      {"--intersect", true},
    {"--candidate", true},    {"--read", true},        {"--level", true},
    {"--include", true},      {"--timeout", true},     {"--memory", true},
    {"--bounds", true},       {"--target", true},      {"--precision", true},
    {"--image-change", true}, {"--t-threshold", true}, {"--origin", true},
    {"--dialect", true},      {"--keep-going", true},  {"--max-ulp", true},
    {"--family", true},       {"--method", true},      {"--severity", true},
    {"--quantity", true},     {"--by", true},          {"--steps", true},
    {"--searches", true},     {"--pixels", true},      {"--secret-file", true},
    {"--strict", false},      {"--all", false}};

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
