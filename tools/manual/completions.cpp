#include "tools/manual/completions.h"

#include <fmt/core.h>

namespace raycheck::tools {
namespace {

std::string names_of(std::span<const ManualCommand> commands) {
  std::string names;
  for (const ManualCommand& command : commands) names += (names.empty() ? "" : " ") + command.name;
  return names;
}

std::string options_of(const ManualCommand& command) {
  std::string names;
  for (const ManualOption& option : command.options) {
    if (option.is_positional) continue;
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

/// Between single quotes of a shell; `also` are other characters that it takes a backslash before.
std::string quoted(const std::string& text, const char* quote, std::string_view also = {}) {
  std::string shown;
  for (const char c : text) {
    if (also.find(c) != std::string_view::npos) shown += '\\';
    c == '\'' ? shown += quote : shown += c;
  }
  return shown;
}

/// Lines of an array of zsh: names and what is said of them.
std::string zsh_options(const ManualCommand& command) {
  std::string lines;
  for (const ManualOption& option : command.options) {
    if (option.is_positional) continue;
    for (const std::string& name : option.names) {
      lines += fmt::format("      '{}:{}'\n", name, quoted(option.text, "'\\''", ":\\"));
    }
  }
  return lines;
}

/// The end of fish's line about an option.
std::string fish_option(const ManualOption& option) {
  std::string names;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    names += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
  }
  return fmt::format("{}{} -d '{}'\n", names, option.value.empty() ? "" : " -r",
                     quoted(option.text, "\\'", "\\"));
}

}  // namespace

std::string bash_completion(const ManualCommand& program, std::span<const ManualCommand> commands) {
  std::string text = fmt::format(
      "# bash completion for raycheck\n"
      "_raycheck() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} words=\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W '{} {}' -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n",
      names_of(commands), options_of(program));
  for (const ManualCommand& command : commands) {
    text += fmt::format("    {}) words='{}' ;;\n", command.name, options_of(command));
  }
  text +=
      "  esac\n"
      "  case $word in\n"
      "    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$word\")) ;;\n"
      "    *) COMPREPLY=($(compgen -f -- \"$word\")) ;;\n"
      "  esac\n"
      "}\n"
      "complete -o filenames -F _raycheck raycheck\n";
  return text;
}

std::string zsh_completion(const ManualCommand& program, std::span<const ManualCommand> commands) {
  std::string text =
      "#compdef raycheck\n"
      "local -a commands options\n"
      "commands=(\n";
  for (const ManualCommand& command : commands) {
    text += fmt::format("  '{}:{}'\n", command.name, quoted(command.sentence, "'\\''", ":\\"));
  }
  text +=
      ")\n"
      "if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then\n"
      "  _describe command commands\n"
      "  return\n"
      "fi\n"
      "case $words[2] in\n";
  for (const ManualCommand& command : commands) {
    text += fmt::format("  {})\n    options=(\n{}    ) ;;\n", command.name, zsh_options(command));
  }
  text += fmt::format("  -*)\n    options=(\n{}    ) ;;\n", zsh_options(program));
  text +=
      "esac\n"
      "if [[ $words[CURRENT] == -* ]]; then\n"
      "  _describe option options\n"
      "else\n"
      "  _files\n"
      "fi\n";
  return text;
}

std::string fish_completion(const ManualCommand& program, std::span<const ManualCommand> commands) {
  std::string text = "# fish completion for raycheck\n";
  for (const ManualCommand& command : commands) {
    text += fmt::format("complete -c raycheck -n __fish_use_subcommand -f -a {} -d '{}'\n",
                        command.name, quoted(command.sentence, "\\'", "\\"));
  }
  for (const ManualOption& option : program.options) {
    text += "complete -c raycheck -n __fish_use_subcommand" + fish_option(option);
  }
  for (const ManualCommand& command : commands) {
    for (const ManualOption& option : command.options) {
      if (option.is_positional) continue;
      text += fmt::format("complete -c raycheck -n '__fish_seen_subcommand_from {}'{}",
                          command.name, fish_option(option));
    }
  }
  return text;
}

}  // namespace raycheck::tools
