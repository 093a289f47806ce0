// The pages and completions say what the program says of itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

std::string manual(const std::string& name) {
  return contents(std::string(RAYCHECK_MANUAL) + "/" + name);
}

/// The names that a text has of long options, as a man page or a shell's script spells them.
std::set<std::string> long_options(std::string text) {
  text = std::regex_replace(text, std::regex("\\\\-"), "-");
  static const std::regex name("(?:^|[^-a-z])(--[a-z][-a-z]*)");
  std::set<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) {
    names.insert((*at)[1]);
  }
  return names;
}

/// What --help lists: the names of an option begin its line, one after the other.
std::set<std::string> options_of(const std::string& command) {
  const std::string help = run(command + " --help").out;
  static const std::regex line("\\n  ((?:--?[a-z][-a-z]*,?)+)");
  std::set<std::string> names;
  for (std::sregex_iterator at(help.begin(), help.end(), line), end; at != end; ++at) {
    names.merge(long_options((*at)[1]));
  }
  return names;
}

std::set<std::string> commands() {
  const std::string help = run("--help").out;
  const std::string list = help.substr(help.find("Subcommands:"));
  static const std::regex line("\\n  ([a-z]+) ");
  std::set<std::string> names;
  for (std::sregex_iterator at(list.begin(), list.end(), line), end; at != end; ++at) {
    names.insert((*at)[1]);
  }
  return names;
}

TEST(Manual, HasAPageForEveryCommandWithEveryOption) {
  EXPECT_GE(commands().size(), 14u);
  const std::string program = manual("man/man1/raycheck.1");
  for (const std::string& command : commands()) {
    EXPECT_NE(program.find("raycheck\\-" + command), std::string::npos) << command;
    const std::string page = manual("man/man1/raycheck-" + command + ".1");
    const std::set<std::string> shown = long_options(page);
    const std::set<std::string> options = options_of(command);
    EXPECT_GE(options.size(), 1u) << command;
    for (const std::string& option : options) EXPECT_TRUE(shown.contains(option)) << option;
  }
}

TEST(Manual, IsSetWithoutWarnings) {
  if (!is_installed("groff")) GTEST_SKIP() << "groff is not installed";
  for (const auto& entry : fs::directory_iterator(std::string(RAYCHECK_MANUAL) + "/man/man1")) {
    const std::string script = temporary_file(
        "groff.sh", "groff -man -ww -Tutf8 '" + entry.path().string() + "' >/dev/null\n");
    EXPECT_EQ(run_bash(script).err, "") << entry.path();
  }
}

/// What bash offers behind these words.
std::string offered(const std::string& words, const std::string& word) {
  const std::string script = temporary_file(
      "complete.sh", "source '" + std::string(RAYCHECK_MANUAL) +
                         "/bash-completion/completions/raycheck'\nCOMP_WORDS=(" + words + " '" +
                         word + "')\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_raycheck\n" +
                         "echo \"${COMPREPLY[@]}\"\n");
  return run_bash(script).out;
}

TEST(Completions, OfBashAreCommandsOptionsAndFiles) {
  EXPECT_EQ(offered("raycheck", "prop"), "properties\n");
  EXPECT_EQ(offered("raycheck check", "--form"), "--format\n");
  EXPECT_EQ(offered("raycheck check", "CMakeLis"), "CMakeLists.txt\n");
  for (const std::string& command : commands()) {
    EXPECT_EQ(offered("raycheck", command).find(command), 0u) << command;
    const std::set<std::string> shown = long_options(" " + offered("raycheck " + command, "--"));
    EXPECT_EQ(shown, options_of(command)) << command;
  }
}

/// Of every command, the line that asks for its options; of the program itself the first.
std::vector<std::string> lines_that_ask_for_options() {
  std::vector<std::string> lines = {"raycheck --"};
  for (const std::string& command : commands()) lines.push_back("raycheck " + command + " --");
  return lines;
}

/// What a shell offers behind lines, a line of words each.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

void expect_all_are_offered(
    const std::function<std::vector<std::string>(const std::vector<std::string>&)>&
        offered_behind) {
  std::vector<std::string> lines = lines_that_ask_for_options();
  const std::size_t questions = lines.size();
  lines.insert(lines.end(), {"raycheck ", "raycheck prop", "raycheck check --form",
                             "raycheck check CMakeLis", "raycheck check --format json CMakeLis"});
  const std::vector<std::string> offers = offered_behind(lines);
  ASSERT_EQ(offers.size(), lines.size());
  const std::set<std::string> of_program = {"--help", "--version"};
  EXPECT_EQ(long_options(" " + offers[0]), of_program);
  std::string all_commands;
  std::size_t at = 1;
  for (const std::string& command : commands()) {
    EXPECT_EQ(long_options(" " + offers[at++]), options_of(command)) << command;
    all_commands += (all_commands.empty() ? "" : " ") + command;
  }
  EXPECT_EQ(offers[questions], all_commands);
  EXPECT_EQ(offers[questions + 1], "properties");
  EXPECT_EQ(offers[questions + 2], "--format");
  EXPECT_EQ(offers[questions + 3], "CMakeLists.txt");
  EXPECT_EQ(offers[questions + 4], "CMakeLists.txt");
}

TEST(Completions, OfZshAreCommandsOptionsAndFiles) {
  if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  expect_all_are_offered([](const std::vector<std::string>& lines) {
    std::string arguments =
        "tests/tools/manual/zsh_offers.py '" RAYCHECK_MANUAL "/zsh/vendor-completions'";
    for (const std::string& line : lines) arguments += " '" + line + "'";
    const Outcome outcome = run_python(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return lines_of(outcome.out);
  });
}

TEST(Completions, OfFishAreCommandsOptionsAndFiles) {
  if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
  expect_all_are_offered([](const std::vector<std::string>& lines) {
    // What is offered, a tab, and what is said of it.
    std::string script = "fish --no-config -c \"source '" RAYCHECK_MANUAL
                         "/fish/vendor_completions.d/raycheck.fish'\n";
    for (const std::string& line : lines) {
      script += "echo (complete -C'" + line + "' | string replace -r '\\t.*' '' | sort)\n";
    }
    const Outcome outcome = run_bash(temporary_file("fish.sh", script + "\""));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return lines_of(outcome.out);
  });
}

}  // namespace
}  // namespace raycheck::tests
