#include <fmt/core.h>

#include <csignal>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "properties/cases/case_text.h"
#include "properties/failures.h"
#include "scene/arithmetic.h"
#include "scene/interruption.h"
#include "scene/invalid_input.h"
#include "tools/edge.h"
#include "tools/report/json.h"
#include "tools/report/version.h"
#include "tools/report/words.h"

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
          fmt::format("{} {}: lies in {}, the folder of a campaign's units; give a file elsewhere",
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

/// The name by which an option was given, "--methods"; its first name if it was not given.
std::string given_name(const CLI::Option& option, std::span<char* const> words) {
  for (const std::string& name : option.get_lnames()) {
    const std::string whole = "--" + name;
    if (std::ranges::any_of(words, [&](std::string_view word) {
          return word.substr(0, word.find('=')) == whole;
        })) {
      return whole;
    }
  }
  return option.get_name();
}

/// The text of an error. Libraries name fields; if an option sets the field, names the option.
/// `words`: the command line.
std::string error_message(const std::exception& error, const CLI::App& command,
                          std::span<char* const> words) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return command.get_name() + ": not enough memory";
  }
  if (const auto* file = dynamic_cast<const fs::filesystem_error*>(&error)) {
    return fmt::format(
        "{}: cannot be read or written: {}; make it accessible, or give another file",
        file->path1().string(), file->code().message());
  }
  const auto* input = dynamic_cast<const scene::InvalidInput*>(&error);
  const CLI::Option* const option =
      input == nullptr ? nullptr : command.get_option_no_throw("--" + input->field());
  if (option == nullptr) return error.what();
  return given_name(*option, words) + std::string(error.what()).substr(input->field().size());
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
    print_error(fmt::format("raycheck: {}\n", error_message(error, *command.app, words)));
    return kExitBadInput;
  }
}

/// Leaves out the names of hidden options, which the parser's formatter shows as empty.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_opts(option);
    for (std::size_t at; (at = text.find("  ")) != std::string::npos;) text.erase(at, 1);
    if (text.ends_with(' ')) text.pop_back();
    constexpr std::string_view kNone = " Excludes:";
    if (text.ends_with(kNone)) text.resize(text.size() - kNone.size());
    return text;
  }
};

/// The number of characters to insert, remove or replace that turns one word into the other.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({replaced, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back();
}

/// The visible option of a command whose name is most like a word; empty if none is.
std::string option_like(const std::string& word, const CLI::App& command) {
  constexpr std::size_t kMostEdits = 2;
  std::string best;
  std::size_t fewest = kMostEdits + 1;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const std::size_t edits = edits_between(word.substr(0, word.find('=')), name);
    if (!name.starts_with("--") || edits >= fewest) continue;
    best = name;
    fewest = edits;
  }
  return best;
}

/// Names the first unknown option, or else the first argument too many.
std::string unexpected_text(const CLI::App& command) {
  const std::vector<std::string> all = command.remaining();
  const auto option =
      std::ranges::find_if(all, [](const std::string& word) { return word.starts_with("-"); });
  if (option == all.end()) {
    return all.empty() ? "" : fmt::format("{}: is one argument too many", all.front());
  }
  const std::string like = option_like(*option, command);
  return fmt::format("{}: there is no such option{}", *option,
                     like.empty() ? "" : fmt::format("; did you mean {}?", like));
}

/// The message of a refused value in the form of all messages about options: "--top x: give ...".
std::string refused_value_text(std::string_view text) {
  const std::size_t colon = text.find(": ");
  if (colon == std::string_view::npos) return std::string(text);
  const std::string_view name = text.substr(0, colon), why = text.substr(colon + 2);
  const auto of_value = [&](std::string_view value, std::string_view what) {
    return fmt::format("{} {}: {}", name, value, what);
  };
  // Of the validators in arguments.cpp.
  constexpr std::string_view kNot = ", not '";
  if (const std::size_t at = why.find(kNot); why.starts_with("give ") && at < why.size()) {
    std::string_view value = why.substr(at + kNot.size());
    value.remove_suffix(1);
    return of_value(value, why.substr(0, at));
  }
  // Of the parser's validators.
  constexpr std::string_view kNotIn = " not in {", kNoFolder = "Directory does not exist: ";
  if (const std::size_t at = why.rfind(kNotIn); at < why.size() && why.ends_with('}')) {
    std::string names;
    for (const char c : why.substr(at + kNotIn.size(), why.size() - at - kNotIn.size() - 1)) {
      names += c == ',' ? ", " : std::string(1, c);
    }
    return of_value(why.substr(0, at), "give one of " + names);
  }
  if (why.starts_with(kNoFolder)) {
    return of_value(why.substr(kNoFolder.size()), "there is no such folder");
  }
  return std::string(text);
}

/// Why the parser refuses the arguments.
std::string refusal_text(const CLI::ParseError& error, const CLI::App& app) {
  const auto commands = app.get_subcommands();
  const CLI::App& command = commands.empty() ? app : *commands.front();
  // A misspelt option may be the one that is missing.
  const bool is_missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (is_missing || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    if (std::string text = unexpected_text(command); !text.empty()) return text;
  }
  if (is_missing && commands.empty()) {
    return "give a command: " + scene::joined(kCommands, ", ", &CommandRow::name);
  }
  if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) {
    return refused_value_text(error.what());
  }
  return error.what();
}

/// Prints the parser's help or error message.
int exit_of(const CLI::ParseError& said, const CLI::App& app) {
  std::ostringstream help, refusal;
  if (app.exit(said, help, refusal) == 0) {
    print_report(help.str());
    return kExitNothingFound;
  }
  const auto commands = app.get_subcommands();
  print_error(fmt::format("raycheck: {}\n`raycheck {}--help` shows the options\n",
                          refusal_text(said, app),
                          commands.empty() ? "" : commands.front()->get_name() + " "));
  return kExitBadInput;
}

}  // namespace

int exit_code(bool was_interrupted, bool found, bool checked) {
  if (was_interrupted) return kExitOfSignal + caught_signal();
  if (found) return kExitDiscrepancy;
  return checked ? kExitNothingFound : kExitNothingChecked;
}

std::vector<Command> make_program(CLI::App& program, std::span<const LinkedCommand> linked) {
  const auto formatter = std::make_shared<HelpFormatter>();
  formatter->label("SUBCOMMAND", "COMMAND");
  program.formatter(formatter);
  program.description("An exact reference for camera rays and ray-sphere intersections");
  program.set_version_flag("--version", std::string(kVersion));
  program.require_subcommand(1);
  std::vector<Command> commands;
  for (const CommandRow& row : kCommands) {
    CLI::App& app = *program.add_subcommand(std::string(row.name), std::string(row.sentence));
    app.group("Commands");
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
    print_error(
        fmt::format("raycheck: this program does not have the command {0}; run `raycheck {0}`\n",
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
