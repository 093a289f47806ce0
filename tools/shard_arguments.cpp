#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <system_error>

#include "scene/invalid_input.h"
#include "tools/edge.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/report/digest.h"
#include "tools/report/version.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Change this when the content of units, or their cases, change between releases.
constexpr std::string_view kUnitShape = "units 3";

bool is_of_units(const CLI::Option& option) {
  const auto is_called = [&](std::string_view name) {
    return option.check_name(std::string(name));
  };
  return option.count() > 0 && !is_called("--out") && !is_called("--shard") &&
         !is_called("--merged") && std::ranges::none_of(kReportOptions, is_called);
}

/// Adds a file, or all files of a folder, but hidden ones and folders of units.
void add_files(const fs::path& path, std::map<std::string, std::string>& files) {
  constexpr std::size_t kMostFiles = 20'000;
  std::error_code error;
  if (fs::is_directory(path, error)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
      const bool is_hidden = entry.path().filename().string().starts_with(".");
      if (!is_hidden && !entry.is_symlink() && !fs::exists(entry.path() / kCampaignFile)) {
        add_files(entry.path(), files);
      }
    }
    return;
  }
  if (!fs::is_regular_file(path, error) || files.contains(path.string())) return;
  if (files.size() == kMostFiles) {
    throw scene::InvalidInput(
        "out", "", fmt::format("the given folders contain more than {} files", kMostFiles));
  }
  files[path.string()] = digest({file_bytes(path)});
}

CampaignIdentity identity_of(const CLI::App& command, Judged judged) {
  CampaignIdentity campaign = {
      command.get_name(), {}, fmt::format("{}, {}", kVersion, kUnitShape), {}};
  for (const CLI::Option* option : command.get_options()) {
    if (!is_of_units(*option)) continue;
    const std::string name = option->get_name();
    const bool is_flag = option->get_items_expected_max() == 0;
    const bool is_known = has(kUnitOptions, name) && has(kFlags, name) == is_flag;
    if (!is_known && !option->get_positional()) {
      throw std::logic_error(name + " is missing in kUnitOptions");
    }
    for (const std::string& value : option->results()) {
      if (!option->get_positional()) campaign.arguments.push_back(name);
      if (!is_flag) campaign.arguments.push_back(value);
    }
    if (!reads(*option)) continue;
    for (const std::string& file : files_of(*option)) add_files(file, campaign.files);
  }
  for (const Implementation& one : judged) {
    campaign.files.insert(one.built_of.begin(), one.built_of.end());
  }
  return campaign;
}

}  // namespace

void add_shards(CLI::App& command, ShardArguments& arguments) {
  command
      .add_option(
          "--out", arguments.out,
          "store each unit of work in this folder, and do only the units that are missing there")
      ->type_name("FOLDER");
  add_shards_inside(command, arguments,
                    "from SLURM_ARRAY_TASK_ID, TEST_SHARD_INDEX or CI_NODE_INDEX, else all");
}

void add_shards_inside(CLI::App& command, ShardArguments& arguments,
                       const std::string& by_default) {
  arguments.command = &command;
  CLI::Option* const out = command.get_option("--out");
  command
      .add_option(
          "--shard", arguments.shard,
          fmt::format("do only share K of N: K/N, or auto/N to take K from the scheduler (default: "
                      "{}); then `raycheck merge FOLDER...` prints the report",
                      by_default))
      ->type_name("K/N")
      ->needs(out);
  command.add_option("--merged", arguments.merged, "folders to merge")->group("")->excludes(out);
}

std::unique_ptr<Units> units_of(const ShardArguments& arguments, Judged judged) {
  if (!arguments.merged.empty()) {
    return std::make_unique<Units>(
        identity_of(*arguments.command, judged),
        std::vector<fs::path>(arguments.merged.begin(), arguments.merged.end()));
  }
  if (arguments.out.empty()) return nullptr;
  const Shard shard = chosen_shard(arguments.shard);
  if (!shard.said_by.empty()) {
    const bool by_option = shard.said_by.starts_with("shard");
    print_error(fmt::format("raycheck: shard {} of {} ({}{})\n", shard.number, shard.of,
                            by_option ? "--" : "", shard.said_by));
  }
  return std::make_unique<Units>(identity_of(*arguments.command, judged), arguments.out, shard);
}

bool runs_candidates(const CampaignIdentity& campaign) {
  return campaign.command == "grade" ||
         std::ranges::find(campaign.arguments, "--candidate") != campaign.arguments.end();
}

int shard_done(const ShardArguments& arguments, const Units& units, bool was_interrupted) {
  const Shard& shard = units.shard();
  for (const char* name :
       {"--format", "--report", "--view", "--certificates", "--save", "--corpus", "--baseline"}) {
    const CLI::Option* const option = arguments.command->get_option_no_throw(name);
    if (option == nullptr || option->count() == 0) continue;
    print_error(fmt::format("raycheck: {} has no effect here: give it to raycheck merge\n", name));
  }
  if (!was_interrupted) {
    print_error(fmt::format(
        "raycheck: shard {} of {} is done; once all are done: raycheck merge {}{}\n", shard.number,
        shard.of, arguments.out, runs_candidates(units.campaign()) ? " --run-candidates" : ""));
  }
  return exit_code(was_interrupted, false, true);
}

}  // namespace raycheck::tools
