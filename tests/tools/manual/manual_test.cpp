// The pages and completions say what the program says of itself.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

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
  if (std::system("command -v groff >/dev/null") != 0) GTEST_SKIP() << "groff is not installed";
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

TEST(Completions, OfOtherShellsAreReadByThem) {
  const std::string zsh = manual("zsh/vendor-completions/_raycheck");
  const std::string fish = manual("fish/vendor_completions.d/raycheck.fish");
  for (const std::string& command : commands()) {
    EXPECT_NE(zsh.find("\n  " + command + ")\n"), std::string::npos) << command;
    EXPECT_NE(fish.find("-a " + command + " "), std::string::npos) << command;
    for (const std::string& option : options_of(command)) {
      EXPECT_NE(zsh.find("'" + option + ":"), std::string::npos) << option;
      EXPECT_NE(fish.find("-l " + option.substr(2)), std::string::npos) << option;
    }
  }
  for (const auto& [shell, file] : {std::pair("zsh", "zsh/vendor-completions/_raycheck"),
                                    std::pair("fish", "fish/vendor_completions.d/raycheck.fish")}) {
    if (std::system((std::string("command -v ") + shell + " >/dev/null").c_str()) != 0) continue;
    const std::string script = temporary_file(
        "syntax.sh", std::string(shell) + " -n '" + RAYCHECK_MANUAL + "/" + file + "'\n");
    EXPECT_EQ(run_bash(script).exit_code, 0) << shell;
  }
}

}  // namespace
}  // namespace raycheck::tests
