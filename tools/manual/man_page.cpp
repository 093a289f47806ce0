#include "tools/manual/man_page.h"

#include <fmt/core.h>

namespace raycheck::tools {
namespace {

/// Text as roff shows it: no line of it is a request, hyphens are those that can be searched for.
std::string roff(const std::string& text) {
  std::string shown;
  bool is_start = true;
  for (const char c : text) {
    if (is_start && (c == '.' || c == '\'')) shown += "\\&";
    if (c == '\\') {
      shown += "\\e";
    } else if (c == '-') {
      shown += "\\-";
    } else if (c == '\'') {
      shown += "\\(aq";
    } else {
      shown += c;
    }
    is_start = c == '\n';
  }
  return shown;
}

std::string header(const std::string& name, const std::string& version) {
  return fmt::format(".TH {} 1 \"\" \"raycheck {}\" \"User Commands\"\n", roff(name), version);
}

/// "--rays TEXT": names in bold, the value in italics.
std::string heading(const ManualOption& option) {
  std::string text;
  for (const std::string& name : option.names) {
    text += fmt::format("{}\\fB{}\\fR", text.empty() ? "" : ", ", roff(name));
  }
  if (!option.value.empty() && !option.is_positional) {
    text += fmt::format(" \\fI{}\\fR", roff(option.value));
  }
  return text;
}

std::string options_text(const ManualCommand& command, bool positional) {
  std::string text;
  for (const ManualOption& option : command.options) {
    if (option.is_positional != positional) continue;
    text += fmt::format(".TP\n{}\n{}\n", heading(option), roff(option.text));
  }
  return text;
}

constexpr const char* kExitCodes =
    ".SH EXIT STATUS\n"
    ".TP\n0\nNothing found; what is excused by a witness is shown.\n"
    ".TP\n1\nA defect.\n"
    ".TP\n2\nBad usage or input; the message names the option, or file, line, field and value.\n"
    ".TP\n4\nNothing found, but nothing or too little was judged, or something is undecided.\n"
    ".TP\n130, 143, 129\nInterrupted; the report covers what was judged until then.\n"
    ".TP\n141\nNobody reads the report any more.\n";

}  // namespace

std::string program_page(const ManualCommand& program, const std::string& version,
                         std::span<const ManualCommand> commands) {
  std::string text = header("RAYCHECK", version);
  text += fmt::format(".SH NAME\nraycheck \\- {}\n", roff(program.sentence));
  text += ".SH SYNOPSIS\n\\fBraycheck\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR ...]\n.SH COMMANDS\n";
  for (const ManualCommand& command : commands) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}; \\fBraycheck\\-{}\\fR(1)\n", command.name,
                        roff(command.sentence), command.name);
  }
  text += ".SH OPTIONS\n" + options_text(program, false) + kExitCodes;
  text += ".SH SEE ALSO\n";
  for (const ManualCommand& command : commands) {
    const bool is_last = &command == &commands.back();
    text += fmt::format("\\fBraycheck\\-{}\\fR(1){}\n", command.name, is_last ? "" : ",");
  }
  return text;
}

std::string command_page(const ManualCommand& command, const std::string& version) {
  std::string text = header("RAYCHECK-" + command.name, version);
  text += fmt::format(
      ".SH NAME\nraycheck\\-{} \\- {}\n.SH SYNOPSIS\n\\fBraycheck {}\\fR "
      "[\\fIOPTION\\fR ...]",
      command.name, roff(command.sentence), command.name);
  for (const ManualOption& option : command.options) {
    if (option.is_positional) text += fmt::format(" \\fI{}\\fR", roff(option.names.front()));
  }
  text += "\n";
  const std::string positionals = options_text(command, true);
  if (!positionals.empty()) text += ".SH ARGUMENTS\n" + positionals;
  text += ".SH OPTIONS\n" + options_text(command, false);
  return text + kExitCodes + ".SH SEE ALSO\n\\fBraycheck\\fR(1)\n";
}

}  // namespace raycheck::tools
