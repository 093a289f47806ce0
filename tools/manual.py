#!/usr/bin/env python3
"""Writes man pages, and completions for bash, from the output of raycheck's --help.

  manual.py RAYCHECK FOLDER   below FOLDER, as they are installed below share
"""

import pathlib
import re
import subprocess
import sys

TEXT = " " * 30  # before the description of an option in --help
EXIT_STATUS = (
    ("0", "Nothing found; answers that are excused by a witness are shown."),
    ("1", "A defect."),
    ("2", "Bad usage or input; the message names the option, or file, line, field and value."),
    ("4", "Nothing found, but nothing or too little was judged, or something is undecided."),
    ("130, 143, 129", "Interrupted; the report covers the part that was judged."),
    ("141", "The reader of the report closed the pipe."))


def printed(*command):
    return subprocess.run(command, text=True, check=True, capture_output=True).stdout


def help_of(program, *command):
    """The sentence of a command; by section, pairs of an option (and value) and its text."""
    lines = printed(program, *command, "--help").splitlines()
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
    """The names of the options."""
    return " ".join(head.split()[0].replace(",", " ") for head, _ in rows)


def roff(text):
    """Text in which no line is a request of man(7), and whose hyphens can be searched for."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")
    return re.sub(r"^\.", r"\\&.", text, flags=re.M)


def bold(rows):
    """Rows whose first words are bold."""
    parts = ((*re.match(r"(\S+)(.*)", head).groups(), text) for head, text in rows)
    return "".join(f".TP\n\\fB{roff(head)}\\fR{roff(value)}\n{roff(text)}\n"
                   for head, value, text in parts)


def page(name, version, sentence, usage, parts, others):
    """A man page in the macros of man(7)."""
    text = f'.TH {roff(name.upper())} 1 "" "raycheck {version}" "User Commands"\n'
    text += f".SH NAME\n{roff(name)} \\- {roff(sentence)}\n"
    text += f".SH SYNOPSIS\n\\fBraycheck\\fR {roff(usage)}\n"
    text += "".join(f".SH {title}\n{bold(rows)}" for title, rows in parts if rows)
    text += ".SH EXIT STATUS\n" + "".join(f".TP\n{head}\n{said}\n" for head, said in EXIT_STATUS)
    see_also = ",\n".join(f"\\fB{roff(other)}\\fR(1)" for other in others)
    return f"{text}.SH SEE ALSO\n{see_also}\n"


def bash(own, commands):
    cases = "".join(f"    {name}) words='{names(rows)}' ;;\n" for name, _, rows in commands)
    return f"""# bash completion for raycheck
_raycheck() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words=
  if [ "$COMP_CWORD" -eq 1 ]; then
    words='{" ".join([names(own), *(name for name, _, _ in commands)])}'
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


def main():
    program, folder = sys.argv[1:3]
    version = printed(program, "--version").strip()
    sentence, sections = help_of(program)
    own = sections["Options"]
    files = {}
    commands = []
    for name, said in sections["Commands"]:
        _, its = help_of(program, name)
        commands.append((name, said, its["Options"]))
        positionals = [head.split()[0] for head, _ in its["Positionals"]]
        usage = " ".join([name, "[OPTION ...]", *positionals])
        files[f"man/man1/raycheck-{name}.1"] = page(
            f"raycheck-{name}", version, said, usage,
            [("ARGUMENTS", its["Positionals"]), ("OPTIONS", its["Options"])], ["raycheck"])
    files["man/man1/raycheck.1"] = page(
        "raycheck", version, sentence, "COMMAND [OPTION ...]",
        [("COMMANDS", [(name, said) for name, said, _ in commands]), ("OPTIONS", own)],
        [f"raycheck-{name}" for name, _, _ in commands])
    files["bash-completion/completions/raycheck"] = bash(own, commands)
    for name, text in files.items():
        path = pathlib.Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


main()
