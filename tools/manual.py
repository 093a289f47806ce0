#!/usr/bin/env python3
"""Writes man pages, and completions for bash, zsh and fish, of what raycheck's --help says.

  manual.py RAYCHECK FOLDER   below FOLDER, as they are installed below share
"""

import pathlib
import re
import subprocess
import sys

VALUE = r"\S+ [A-Z]{2}"  # what begins with an option that takes one
TEXT = " " * 30  # before what --help says of an option
EXIT_STATUS = (
    ("0", "Nothing found; what is excused by a witness is shown."),
    ("1", "A defect."),
    ("2", "Bad usage or input; the message names the option, or file, line, field and value."),
    ("4", "Nothing found, but nothing or too little was judged, or something is undecided."),
    ("130, 143, 129", "Interrupted; the report covers what was judged until then."),
    ("141", "Nobody reads the report any more."))


def help_of(program, *command):
    """A sentence, and by section pairs: an option with its value, and what is said of it."""
    shown = subprocess.run([program, *command, "--help"], text=True, check=True, capture_output=True)
    lines = shown.stdout.splitlines()
    sections = {"Positionals": [], "Options": []}
    for line, following in zip(lines, lines[1:] + [""]):
        if re.fullmatch(r"\w+:", line):
            rows = sections.setdefault(line[:-1], [])
        elif line.startswith(TEXT):
            rows[-1] = (rows[-1][0], line.strip())
        elif not line.startswith("  "):
            rows = []  # of no section
        else:
            end = len(line) if following.startswith(TEXT) else len(TEXT)
            rows.append((line[:end].strip(), line[end:]))
    return lines[0], sections


def names(rows):
    """What each of the options is called, and what is said of it."""
    return [(name, text) for head, text in rows for name in head.split()[0].split(",")]


def roff(text):
    """Text none of whose lines is a request, with hyphens that can be searched for."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")
    return re.sub(r"^\.", r"\\&.", text, flags=re.M)


def bold(rows):
    """Rows whose first words are bold."""
    return "".join(f".TP\n\\fB{roff(head)}\\fR{roff(value)}\n{roff(text)}\n"
                   for head, value, text in ((*re.match(r"(\S+)(.*)", head).groups(), text) for head, text in rows))


def page(name, version, sentence, usage, parts, others):
    """A man page in the macros of man(7)."""
    text = f'.TH {roff(name.upper())} 1 "" "raycheck {version}" "User Commands"\n'
    text += f".SH NAME\n{roff(name)} \\- {roff(sentence)}\n.SH SYNOPSIS\n\\fBraycheck\\fR {roff(usage)}\n"
    text += "".join(f".SH {title}\n{bold(rows)}" for title, rows in parts if rows)
    text += ".SH EXIT STATUS\n" + "".join(f".TP\n{head}\n{said}\n" for head, said in EXIT_STATUS)
    return text + ".SH SEE ALSO\n" + ",\n".join(f"\\fB{roff(other)}\\fR(1)" for other in others) + "\n"


def bash(own, commands):
    cases = "".join(f"    {name}) words='{' '.join(option for option, _ in names(rows))}' ;;\n"
                    for name, _, rows in commands)
    return f"""# bash completion for raycheck
_raycheck() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words=
  if [ "$COMP_CWORD" -eq 1 ]; then
    words='{" ".join([name for name, _ in names(own)] + [name for name, _, _ in commands])}'
    COMPREPLY=($(compgen -W "$words" -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{cases}  esac
  case $word in
    -*) COMPREPLY=($(compgen -W "$words" -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}}
complete -o filenames -F _raycheck raycheck
"""


def zsh(own, commands):
    def described(pairs):
        quoted = [(name, re.sub(r"([:\\])", r"\\\1", text).replace("'", "'\\''")) for name, text in pairs]
        return "".join(f"\n    '{name}:{text}'" for name, text in quoted)

    cases = "".join(f"  {name}) options=({described(names(rows))}) ;;\n"
                    for name, rows in [(name, rows) for name, _, rows in commands] + [("-*", own)])
    return f"""#compdef raycheck
local -a commands options
commands=({described([(name, sentence) for name, sentence, _ in commands])})
if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then
  _describe command commands
  return
fi
case $words[2] in
{cases}esac
if [[ $words[CURRENT] == -* ]]; then
  _describe option options
else
  _files
fi
"""


def fish(own, commands):
    def lines(condition, rows):
        for head, text in rows:
            options = "".join(f" -{'l' if name.startswith('--') else 's'} {name.lstrip('-')}"
                              for name, _ in names([(head, text)]))
            yield f"complete -c raycheck -n '{condition}'{options}{' -r' if re.match(VALUE, head) else ''} -d {quoted(text)}\n"

    def quoted(text):
        return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"

    text = "# fish completion for raycheck\n"
    for name, sentence, _ in commands:
        text += f"complete -c raycheck -n __fish_use_subcommand -f -a {name} -d {quoted(sentence)}\n"
    text += "".join(lines("__fish_use_subcommand", own))
    return text + "".join(line for name, _, rows in commands
                          for line in lines(f"__fish_seen_subcommand_from {name}", rows))


def main():
    program, folder = sys.argv[1:3]
    version = subprocess.run([program, "--version"], text=True, check=True, capture_output=True).stdout.strip()
    sentence, sections = help_of(program)
    own = sections["Options"]
    files = {}
    commands = []
    for name, said in sections["Subcommands"]:
        _, its = help_of(program, name)
        commands.append((name, said, its["Options"]))
        usage = " ".join([name, "[OPTION ...]"] + [head.split()[0] for head, _ in its["Positionals"]])
        files[f"man/man1/raycheck-{name}.1"] = page(
            f"raycheck-{name}", version, said, usage,
            [("ARGUMENTS", its["Positionals"]), ("OPTIONS", its["Options"])], ["raycheck"])
    files["man/man1/raycheck.1"] = page(
        "raycheck", version, sentence, "COMMAND [OPTION ...]",
        [("COMMANDS", [(name, said) for name, said, _ in commands]), ("OPTIONS", own)],
        [f"raycheck-{name}" for name, _, _ in commands])
    files["bash-completion/completions/raycheck"] = bash(own, commands)
    files["zsh/vendor-completions/_raycheck"] = zsh(own, commands)
    files["fish/vendor_completions.d/raycheck.fish"] = fish(own, commands)
    for name, text in files.items():
        path = pathlib.Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


main()
