#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <new>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "properties/cases/case_text.h"
#include "properties/failures.h"
#include "scene/arithmetic.h"
#include "scene/interruption.h"
#include "scene/invalid_input.h"
#include "scene/text.h"
#include "tools/commands.h"
#include "tools/flags.h"
#include "tools/report/json.h"
#include "tools/report/output_file.h"
#include "tools/report/version.h"
#include "tools/report/words.h"
#include "tools/terminal.h"

namespace raycheck::tools {

namespace {

namespace fs = std::filesystem;

/// Options whose value is a file to write. (For --report, the file follows the format.)
constexpr const char* kWriting[] = {"--certificates", "--out",  "--package",
                                    "--report",       "--save", "--view"};

struct Written {
  const CLI::Option* option;
  std::string named_by, path;
};

std::vector<Written> written_by(const CLI::App& command) {
  std::vector<Written> all;
  for (const char* name : kWriting) {
    const CLI::Option* const option = command.get_option_no_throw(name);
    if (option == nullptr) continue;
    for (const std::string& value : option->results()) {
      const std::size_t kind = option->check_name("--report") ? value.find('=') + 1 : 0;
      all.push_back({option, name, value.substr(kind)});
    }
  }
  const CLI::Option* const updates = command.get_option_no_throw("--update-baseline");
  if (updates != nullptr && updates->count() > 0) {
    const CLI::Option* const baseline = command.get_option("--baseline");
    for (const std::string& value : baseline->results()) {
      all.push_back({baseline, "--baseline", value});
    }
  }
  return all;
}

bool is_same(const std::string& a, const std::string& b) {
  std::error_code error;
  const fs::path one = fs::weakly_canonical(a, error), other = fs::weakly_canonical(b, error);
  return !a.empty() && !error && one == other;
}

/// Throws std::invalid_argument if a file to write lies in a folder of units, where it could
/// replace a unit.
void require_no_unit(const CLI::App& command, const Written& file) {
  for (const char* name : {"--merged", "--out"}) {
    const CLI::Option* const option = command.get_option_no_throw(name);
    if (option == nullptr || option == file.option) continue;
    for (const std::string& folder : option->results()) {
      std::error_code error;
      const fs::path inside = fs::weakly_canonical(folder, error);
      const fs::path path = fs::weakly_canonical(file.path, error);
      if (std::ranges::mismatch(inside, path).in1 != inside.end()) {
        continue;
      }
      throw std::invalid_argument(
          fmt::format("{} {}: lies in {}, a campaign's folder of units; give a file elsewhere",
                      file.named_by, file.path, folder));
    }
  }
}

/// Throws std::invalid_argument if another argument of the command also names, directly or through
/// links, a file that an option writes: to read it (also as a word of a candidate), or to write it.
/// Domain: a command whose arguments are parsed.
void require_written_apart(const CLI::App& command) {
  const std::vector<Written> all = written_by(command);
  for (auto one = all.begin(); one != all.end(); ++one) {
    const bool is_twice = std::any_of(
        one + 1, all.end(), [&](const Written& next) { return is_same(one->path, next.path); });
    if (is_twice) {
      throw std::invalid_argument(
          fmt::format("{} {}: the file would be written twice", one->named_by, one->path));
    }
    require_no_unit(command, *one);
    std::error_code error;
    if (!fs::is_regular_file(one->path, error)) continue;
    for (const CLI::Option* option : command.get_options()) {
      const bool is_written =
          std::ranges::any_of(all, [&](const Written& other) { return other.option == option; });
      if (is_written || !reads(*option)) continue;
      require_no_input(one->named_by, one->path, files_of(*option));
    }
  }
}

/// Ends a command that was interrupted before it had results, or before all of its report was
/// written.
int end_without_report(const CLI::App& command) {
  if (has_written_out()) {
    print_error("raycheck: interrupted before everything was written\n");
    return exit_code(true, false, false);
  }
  const CLI::Option* const format = command.get_option_no_throw("--format");
  if (format != nullptr && format->count() > 0 && format->results().back() == "json") {
    print_report(interrupted_json_text(command.get_name()));
  }
  print_error("raycheck: interrupted before there was anything to report\n");
  return exit_code(true, false, false);
}

/// The message of an error. Libraries name a field; if an option sets that field, the message names
/// the option.
std::string error_message(const std::exception& error, const CLI::App& command) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return command.get_name() + ": not enough memory";
  }
  if (const auto* file = dynamic_cast<const fs::filesystem_error*>(&error)) {
    return fmt::format("{}: cannot be read or written: {}; change its permissions, or give another",
                       file->path1().string(), file->code().message());
  }
  const auto* input = dynamic_cast<const scene::InvalidInput*>(&error);
  const bool is_option =
      input != nullptr && command.get_option_no_throw("--" + input->field()) != nullptr;
  return std::string(is_option ? "--" : "") + error.what();
}

/// The message of an internal error; `words`: the command line.
std::string internal_error_message(const std::exception& error, std::span<char* const> words) {
  std::string text = fmt::format(
      "raycheck: internal error: {}\nThis is a bug in raycheck, not in the code that it judges; "
      "there is no verdict. Report it with this command:\n ",
      error.what());
  for (const char* word : words) text += " " + single_quoted(word);
  const auto* ours = dynamic_cast<const properties::InternalError*>(&error);
  if (ours == nullptr || !ours->the_case) return text + "\n";
  return text + "\nand this case:\n" + properties::scene_text(*ours->the_case, "internal error");
}

/// Runs a command and returns its exit code, whatever the command throws.
int outcome_of(const Command& command, std::span<char* const> words) {
  const std::function<bool()> is_interrupted = interrupted;
  try {
    const scene::Interruptible interruptible(is_interrupted);
    require_written_apart(*command.app);
    return command.run();
  } catch (const scene::Interrupted&) {
    return end_without_report(*command.app);
  } catch (const std::exception& error) {
    // After a signal, errors may be consequences of it.
    if (interrupted()) return end_without_report(*command.app);
    const bool is_ours = dynamic_cast<const std::logic_error*>(&error) != nullptr &&
                         dynamic_cast<const std::invalid_argument*>(&error) == nullptr;
    if (is_ours) {
      print_error(internal_error_message(error, words));
      return kExitInternal;
    }
    print_error(fmt::format("raycheck: {}\n", error_message(error, *command.app)));
    return kExitBadInput;
  }
}

/// Prints the parser's help or error message.
int exit_of(const CLI::ParseError& said, const CLI::App& app) {
  std::ostringstream help, refusal;
  const bool is_help = app.exit(said, help, refusal) == 0;
  print_error(refusal.str());
  if (is_help) print_report(help.str());
  return is_help ? kExitNothingFound : kExitBadInput;
}

}  // namespace

int exit_code(bool was_interrupted, bool found, bool checked) {
  if (was_interrupted) return kExitOfSignal + caught_signal();
  if (found) return kExitDiscrepancy;
  return checked ? kExitNothingFound : kExitNothingChecked;
}

std::vector<Command> make_program(CLI::App& program, std::span<const LinkedCommand> linked) {
  program.description("An exact reference for camera rays and ray-sphere intersections");
  program.set_version_flag("--version", std::string(kVersion));
  program.require_subcommand(1);
  std::vector<Command> commands;
  for (const CommandRow& row : kCommands) {
    CLI::App& app = *program.add_subcommand(std::string(row.name), std::string(row.sentence));
    const auto found = std::ranges::find(linked, row.name, &LinkedCommand::name);
    if (found != linked.end()) commands.push_back({&app, found->add(app)});
  }
  return commands;
}

int run_command_line(int argc, char** argv, std::span<const LinkedCommand> linked) {
  hold_standard_streams();
  catch_signals();
  if (const std::string defect = scene::arithmetic_defect(); !defect.empty()) {
    print_error("raycheck: " + defect + ": error bounds would not hold\n");
    return kExitBadInput;
  }
  CLI::App app;
  const std::vector<Command> commands = make_program(app, linked);
  for (const Command& command : commands) {
    for (CLI::Option* option : command.app->get_options()) {
      if (option->get_items_expected_max() > 0) option->check(kGiven);
    }
  }
  const std::string first = argc > 1 ? argv[1] : "";
  if (!first.empty() && first.front() != '-' && find_command(first) == nullptr) {
    print_error(fmt::format("raycheck: there is no command '{}'; the commands are {}\n", first,
                            scene::joined(kCommands, ", ", &CommandRow::name)));
    return kExitBadInput;
  }
  try {
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return exit_of(error, app);
    }
    for (const Command& command : commands) {
      if (command.app->parsed()) return outcome_of(command, {argv, static_cast<std::size_t>(argc)});
    }
    print_error(fmt::format("raycheck: this program lacks the command {0}; run `raycheck {0}`\n",
                            app.get_subcommands().front()->get_name()));
    return kExitBadInput;
  } catch (const ClosedPipe&) {
    return kExitOfSignal + SIGPIPE;
  } catch (const scene::Interrupted&) {  // the reader of the report is gone
    return exit_code(true, false, false);
  } catch (const std::exception& error) {  // help, or a partial report, was not written
    print_error(fmt::format("raycheck: {}\n", error.what()));
    return kExitBadInput;
  }
}

}  // namespace raycheck::tools
