// Man pages and completions agree with the program's help.

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

std::string manual(const std::string& name) {
  return contents(std::string(RAYCHECK_MANUAL) + "/" + name);
}

/// The names of long options in a text, as spelled in a man page or a shell script.
std::set<std::string> long_options(std::string text) {
  text = std::regex_replace(text, std::regex("\\\\-"), "-");
  static const std::regex name("(?:^|[^-a-z])(--[a-z][-a-z]*)");
  std::set<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) {
    names.insert((*at)[1]);
  }
  return names;
}

/// The options in --help: the names of an option begin its line, one after the other.
std::set<std::string> options_of(const std::string& command) {
  const std::string help = run(command + " --help").out;
  static const std::regex line("\\n  ((?:--?[a-z][-a-z]*,?)+)");
  std::set<std::string> names;
  for (std::sregex_iterator at(help.begin(), help.end(), line), end; at != end; ++at) {
    names.merge(long_options((*at)[1]));
  }
  return names;
}

TEST(Manual, HasAPageForEveryCommandWithEveryOption) {
  const std::string program = manual("man/man1/raycheck.1");
  for (const std::string& command : all_commands()) {
    EXPECT_TRUE(has(program, "raycheck\\-" + command)) << command;
    const std::string page = manual("man/man1/raycheck-" + command + ".1");
    const std::set<std::string> shown = long_options(page);
    const std::set<std::string> options = options_of(command);
    EXPECT_GE(options.size(), 1u) << command;
    for (const std::string& option : options) EXPECT_TRUE(shown.contains(option)) << option;
  }
}

TEST(Manual, IsTypesetWithoutWarnings) {
  if (!is_installed("groff")) GTEST_SKIP() << "groff is not installed";
  for (const auto& entry : fs::directory_iterator(std::string(RAYCHECK_MANUAL) + "/man/man1")) {
    const std::string page = quoted(entry.path());
    EXPECT_EQ(run_bash("groff -man -ww -Tutf8 " + page + " >/dev/null\n").err, "") << page;
  }
}

TEST(Completions, OfBashAreCommandsOptionsAndFiles) {
  const std::vector<std::string> commands = all_commands();
  std::vector<std::string> lines = {"raycheck --"};
  for (const std::string& command : commands) lines.push_back("raycheck " + command + " --");
  const std::size_t questions = lines.size();
  lines.insert(lines.end(), {"raycheck ", "raycheck prop", "raycheck check --form",
                             "raycheck check CMakeLis", "raycheck check --format json CMakeLis"});
  std::string script = "source '" RAYCHECK_MANUAL
                       "/bash-completion/completions/raycheck'\n"
                       "offer() {\n  COMP_WORDS=(\"$@\")\n  COMP_CWORD=$(($# - 1))\n  _raycheck\n"
                       "  echo $(printf '%s\\n' \"${COMPREPLY[@]}\" | sort)\n}\n";
  for (const std::string& line : lines) {
    script += "offer " + line + (line.back() == ' ' ? "''\n" : "\n");
  }
  const auto offers = lines_of(run_bash(script).out);
  ASSERT_EQ(offers.size(), lines.size());
  EXPECT_EQ(long_options(" " + offers[0]), (std::set<std::string>{"--help", "--version"}));
  std::string names;
  for (std::size_t k = 0; k < commands.size(); ++k) {
    EXPECT_EQ(long_options(" " + offers[k + 1]), options_of(commands[k])) << commands[k];
    names += (names.empty() ? "" : " ") + commands[k];
  }
  EXPECT_TRUE(offers[questions].ends_with(names)) << offers[questions];
  EXPECT_EQ(offers[questions + 1], "properties");
  EXPECT_EQ(offers[questions + 2], "--format");
  EXPECT_EQ(offers[questions + 3], "CMakeLists.txt");
  EXPECT_EQ(offers[questions + 4], "CMakeLists.txt");
}

}  // namespace
}  // namespace raycheck::tests
