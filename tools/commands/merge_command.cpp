#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "tools/edge.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

struct MergeArguments {
  std::vector<std::string> folders;
  std::map<std::string, std::vector<std::string>> passed;  ///< Report options with values.
  std::map<std::string, bool> flags;                       ///< Report options without values.
  bool may_run = false;
};

/// Reports the programs that the merge runs, because the folder names them and may come from
/// anyone.
void report_what_runs(const CampaignIdentity& campaign, const std::string& folder, bool may_run) {
  if (!runs_candidates(campaign)) return;
  const std::string warning =
      fmt::format("{}: its campaign runs candidates: {}", folder, campaign.text());
  if (!may_run) {
    throw std::invalid_argument(warning +
                                "; add --run-candidates if you trust them and the folder");
  }
  print_error(fmt::format("raycheck: {}\n", warning));
}

/// Runs the campaign's command, which reads its units from the folders.
int run_merge(const MergeArguments& arguments) {
  const CampaignIdentity campaign = campaign_in(arguments.folders.front());
  const CommandRow* const row = find_command(campaign.command);
  if (row == nullptr) {
    throw std::invalid_argument(
        fmt::format("{}: was made by the command {}, which this version does not have",
                    arguments.folders.front(), campaign.command));
  }
  std::vector<std::string> words = {"raycheck", campaign.command};
  const auto& all = campaign.arguments;
  for (auto argument = all.begin(); argument != all.end(); ++argument) {
    if (!argument->starts_with("-")) {
      words.push_back(*argument);
      continue;
    }
    const bool has_value = !has(kFlags, *argument);
    if (!has(kUnitOptions, *argument) || (has_value && std::next(argument) == all.end())) {
      throw std::invalid_argument(fmt::format(
          "{}: its campaign has {}, which raycheck never writes: the folder was changed",
          arguments.folders.front(), *argument));
    }
    // One word, so that a value that begins with '-' is not read as an option.
    words.push_back(has_value ? *argument + "=" + *std::next(argument) : *argument);
    if (has_value) ++argument;
  }
  report_what_runs(campaign, arguments.folders.front(), arguments.may_run);
  for (const std::string& folder : arguments.folders) words.push_back("--merged=" + folder);
  for (const auto& [option, values] : arguments.passed) {
    for (const std::string& value : values) words.push_back(option + "=" + value);
  }
  for (const auto& [option, is_given] : arguments.flags) {
    if (is_given) words.push_back(option);
  }
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const fs::path program =
      fs::read_symlink("/proc/self/exe").parent_path() / std::string(row->program);
  execv(program.c_str(), pointers.data());
  throw std::runtime_error(fmt::format("{}: {}", program.string(), std::strerror(errno)));
}

}  // namespace

CommandRun add_merge(CLI::App& command) {
  const auto given = std::make_shared<MergeArguments>();
  command.add_option("FOLDER", given->folders, "the folders that shards wrote with --out")
      ->required()
      ->type_name("FOLDER");
  command.add_flag("--run-candidates", given->may_run,
                   "allow raycheck to run the campaign's candidates or submissions");
  for (const std::string_view option : kReportOptions) {
    const std::string name(option), meaning = "as in the command that made the folders";
    if (has(kFlags, name)) {
      command.add_flag(name, given->flags[name], meaning);
      continue;
    }
    command.add_option(name, given->passed[name], meaning)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->expected(1)
        ->take_all();
  }
  return [given] { return run_merge(*given); };
}

}  // namespace raycheck::tools
