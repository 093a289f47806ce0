#!/usr/bin/env python3
"""Writes the documents that show real runs.

    python3 docs/generate.py            docs/error-against-run-time.md, from its template
    python3 docs/generate.py --shown    the console blocks of README.md and the others

In a template a line `{{ARGUMENTS}}` stands for what `./run ARGUMENTS` prints. In a console block
`$ ./run ARGUMENTS` is followed by what it prints; where the block elides lines by `...`, it stays
as it is and must be looked after by hand.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def printed(arguments):
    """What the program prints; it exits with 1 where it found something, which is no failure."""
    result = subprocess.run(f"./run {arguments}", shell=True, cwd=ROOT, text=True,
                            capture_output=True)
    if result.returncode not in (0, 1):
        sys.exit(f"./run {arguments}: {result.stderr}")
    return result.stdout


def worst_table():
    """The worst inputs known, from the first lines of tests/regressions/worst/."""
    rows = ["| method | worst known | file |", "|---|---|---|"]
    for path in sorted((ROOT / "tests/regressions/worst").glob("*.toml")):
        line = path.read_text().splitlines()[0]
        method, what = re.match(r"# (\S+) (.*)", line).groups()
        rows.append(f"| `{method}` | {what} | {path.name} |")
    return "\n".join(rows)


def from_template(name):
    template = (ROOT / "docs" / f"{name}.in.md").read_text()
    text = template.replace("{{worst-table}}", worst_table())
    text = re.sub(r"^\{\{(.*)\}\}$", lambda match: printed(match[1]).strip(), text,
                  flags=re.MULTILINE)
    (ROOT / "docs" / f"{name}.md").write_text(text)


def shown(path):
    """Runs the console blocks of a file again, those that show all lines."""
    def again(match):
        arguments, lines = match[1], match[2]
        if "\n...\n" in "\n" + lines:
            print(f"{path.name}: by hand: ./run {arguments}")
            return match[0]
        return f"```console\n$ ./run {arguments}\n{printed(arguments)}```"

    text = path.read_text()
    path.write_text(re.sub(r"```console\n\$ \./run (.*)\n((?:(?!```).*\n)*)```", again, text))


if __name__ == "__main__":
    if sys.argv[1:] == ["--shown"]:
        for path in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]:
            shown(path)
    else:
        from_template("error-against-run-time")
