#include "tools/shard_arguments.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "tools/arguments.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/report/digest.h"
#include "tools/report/version.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Another shape of units is another campaign.
constexpr std::string_view kUnitShape = "units 1";

bool is_of_units(const CLI::Option& option) {
  const auto is_called = [&](const char* name) { return option.check_name(name); };
  return option.count() > 0 && !is_called("--out") && !is_called("--shard") &&
         !is_called("--merged") &&
         std::none_of(std::begin(kReportOptions), std::end(kReportOptions),
                      [&](const ReportOption& one) { return is_called(one.name); });
}

CampaignIdentity identity_of(const CLI::App& command) {
  CampaignIdentity campaign = {command.get_name(), {}, {}};
  std::vector<std::string> texts = {std::string(kVersion), std::string(kUnitShape),
                                    campaign.command};
  for (const CLI::Option* option : command.get_options()) {
    if (!is_of_units(*option)) continue;
    const bool is_flag = option->get_items_expected_max() == 0;
    for (const std::string& value : option->results()) {
      if (!option->get_positional()) campaign.arguments.push_back(option->get_name());
      if (!is_flag) campaign.arguments.push_back(value);
    }
    for (const std::string& file : files_of(*option)) {
      std::error_code error;
      if (fs::is_regular_file(file, error)) texts.push_back(digest({file_bytes(file)}));
    }
  }
  texts.insert(texts.end(), campaign.arguments.begin(), campaign.arguments.end());
  campaign.digest = digest(texts);
  return campaign;
}

}  // namespace

void add_shards(CLI::App& command, ShardArguments& arguments) {
  command
      .add_option("--out", arguments.out,
                  "keep each unit of the work in this folder, and do only what is missing there")
      ->type_name("FOLDER");
  add_shards_inside(command, arguments);
}

void add_shards_inside(CLI::App& command, ShardArguments& arguments) {
  arguments.command = &command;
  CLI::Option* const out = command.get_option("--out");
  command
      .add_option("--shard", arguments.shard,
                  "of N workers the K-th: K/N, or auto/N; default: what SLURM_ARRAY_TASK_ID, "
                  "JOB_COMPLETION_INDEX, TEST_SHARD_INDEX or CI_NODE_INDEX says, else all; "
                  "`raycheck merge FOLDER...` reports")
      ->type_name("K/N")
      ->needs(out);
  command.add_option("--merged", arguments.merged, "what merge merges")->group("")->excludes(out);
}

std::unique_ptr<Units> units_of(const ShardArguments& arguments) {
  if (!arguments.merged.empty()) {
    return std::make_unique<Units>(
        identity_of(*arguments.command),
        std::vector<fs::path>(arguments.merged.begin(), arguments.merged.end()));
  }
  if (arguments.out.empty()) return nullptr;
  const Shard shard = chosen_shard(arguments.shard);
  if (!shard.said_by.empty()) {
    const bool by_option = shard.said_by.starts_with("shard");
    print_error(fmt::format("raycheck: shard {} of {} ({}{})\n", shard.number, shard.of,
                            by_option ? "--" : "", shard.said_by));
  }
  return std::make_unique<Units>(identity_of(*arguments.command), arguments.out, shard);
}

int shard_done(const ShardArguments& arguments, const Units& units, bool was_interrupted) {
  const Shard& shard = units.shard();
  if (!was_interrupted) {
    print_error(fmt::format("raycheck: shard {} of {} is done; once all are: raycheck merge {}\n",
                            shard.number, shard.of, arguments.out));
  }
  return exit_code(was_interrupted, false, true);
}

}  // namespace raycheck::tools
