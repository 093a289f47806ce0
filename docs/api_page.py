#!/usr/bin/env python3
"""Writes docs/api.md, the reference of libraycheck's headers, from their comments, with Doxygen.

    python3 docs/api_page.py            docs/api.md
    python3 docs/api_page.py --check    writes nothing; exits with 1 if the page is stale or a
                                        public name has no comment, and with 77 without doxygen

The first comment of a header is the header's text on the page. Fields on one line share a comment.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADERS = ROOT / "include/raycheck"
PAGE = ROOT / "docs/api.md"
SKIPPED = 77
# In the order of the page; headers that others include come first.
ORDER = ["scene", "exact", "batch", "cases", "judge", "law_tests", "gtest", "catch2", "doctest", "rapidcheck",
         "fuzz", "api"]
CONFIGURATION = f"""
INPUT = {HEADERS}
FILE_PATTERNS = *.h
EXCLUDE_PATTERNS = candidate.h
GENERATE_XML = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
AUTOLINK_SUPPORT = NO
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = RAYCHECK_API= __attribute__(x)=
QUIET = YES
WARNINGS = NO
"""
TOP = """# The API of libraycheck

<!-- Written by `python3 docs/api_page.py` from the comments of include/raycheck: change those. -->

[library.md](library.md) shows how to use the library. [candidates.md](candidates.md) describes `raycheck/candidate.h` and
`candidate.hpp`, which are for code that the program `raycheck` judges. Everything is in the
namespace `raycheck`, except the names of `raycheck/batch.h`, which is in C.
"""


def words(node):
    """The text of a node on one line, code between backticks."""
    text = node.text or ""
    for child in node:
        inner = words(child)
        text += f"`{inner}`" if child.tag == "computeroutput" else inner
        text += child.tail or ""
    return re.sub(r"\s+", " ", text).strip(" ") if node.tag == "para" else text


def said(node):
    """The comment of a member or a class, in paragraphs; Domain, Errors and the like begin one."""
    paragraphs = [words(para) for kind in ("briefdescription", "detaileddescription")
                  for para in node.findall(f"{kind}/para")]
    text = "\n\n".join(paragraphs)
    return re.sub(r"(?<=\S) (?=(?:Shape|Units|Domain|Errors?|Source|Thread safety): )", "\n\n", text)


def code(node):
    """A type or a list of arguments, formatted as in our code."""
    text = "".join(node.itertext()) if node is not None else ""
    text = re.sub(r"\s+", " ", text).strip()
    return re.sub(r" ([&*>])", r"\1", text.replace("< ", "<"))


def place(node):
    """Header and line."""
    location = node.find("location")
    if location is None:
        return None, 0
    return pathlib.Path(location.get("file")).stem, int(location.get("line"))


def arguments(member):
    """The arguments of a function, with names and defaults, and what follows them."""
    texts = []
    for one in member.findall("param"):
        text = f"{code(one.find('type'))} {one.findtext('declname') or ''}".strip()
        default = code(one.find("defval"))
        texts.append(text + (f" = {default}" if default else ""))
    said = [f" {word}" for word in ("const", "noexcept") if member.get(word) == "yes"]
    return f"({', '.join(texts)})" + "".join(said)


def is_c(name):
    return name.startswith("raycheck_")


def signature(member):
    """A declaration; its name includes the namespace if that is nested in raycheck."""
    kind, name = member.get("kind"), member.findtext("name")
    if member.get("id").startswith("namespace"):
        name = (member.findtext("qualifiedname") or name).removeprefix("raycheck::")
    if kind == "define":
        parameters = [code(one.find("defname")) for one in member.findall("param")]
        return f"#define {name}" + (f"({', '.join(parameters)})" if parameters else "")
    if kind == "enum":
        values = ", ".join(code(value.find("name")) for value in member.findall("enumvalue"))
        return f"enum {'' if is_c(name) else 'class '}{name} {{ {values} }}"
    words_before = [word for word in ("explicit", "static") if member.get(word) == "yes"]
    type_text = code(member.find("type"))
    before = " ".join(words_before + [type_text]).strip()
    return f"{before} {name}{arguments(member)}".strip() + ";"


class Page:
    def __init__(self):
        self.entries = {}  # for each header: lines and texts
        self.unsaid = []

    def add(self, place_of, text):
        header, line = place_of
        self.entries.setdefault(header, []).append((line, text))

    def require(self, text, node, name):
        if not text:
            header, line = place(node)
            self.unsaid.append(f"{header}.h:{line}: {name} has no comment")
        return text

    def of_function(self, member, owner=""):
        name = owner + member.findtext("name")
        text = self.require(said(member), member, name)
        return f"```cpp\n{signature(member)}\n```\n\n{text}\n"

    def of_enum(self, member):
        name = member.findtext("qualifiedname") or member.findtext("name")
        text = f"### `{signature(member)}`\n\n{self.require(said(member), member, name)}\n"
        rows = [(value.findtext("name"), said(value)) for value in member.findall("enumvalue")]
        if any(row[1] for row in rows):
            for value, sentence in rows:
                self.require(sentence, member, f"{name}::{value}")
            text += "\n" + table(rows)
        return text

    def of_class(self, compound):
        name = compound.findtext("compoundname").removeprefix("raycheck::")
        text = f"### `{compound.get('kind')} {name}`\n\n"
        text += self.require(said(compound), compound, name) + "\n"
        members = [member for section in compound.findall("sectiondef")
                   for member in section if member.get("prot") == "public"]
        fields, functions = [], []
        for member in sorted(members, key=lambda one: place(one)[1]):
            if member.get("kind") == "variable":
                fields.append(member)
            elif member.get("kind") == "function":
                functions.append(member)
        text += self.of_fields(fields, name)
        for member in functions:
            text += "\n" + self.of_function(member, f"{name}::")
        return text

    def of_fields(self, fields, owner):
        lines = {}
        for field in fields:
            lines.setdefault((place(field)[1], code(field.find("type"))), []).append(field)
        rows = []
        for (_, type_text), together in lines.items():
            names = [field.findtext("name") for field in together]
            sentence = " ".join(filter(None, map(said, together)))
            self.require(sentence, together[0], f"{owner}::{names[0]}")
            rows.append((f"{type_text} {', '.join(names)}", sentence))
        return "\n" + table(rows) if rows else ""


def table(rows):
    lines = ["| | |", "|---|---|"]
    for name, sentence in rows:
        name, sentence = (re.sub(r"\n+", " ", text).replace("|", "\\|") for text in (name, sentence))
        lines.append(f"| `{name}` | {sentence} |")
    return "\n".join(lines) + "\n"


def own_comment(header):
    """The first comment of a header; indented lines are code."""
    text = (HEADERS / f"{header}.h").read_text()
    match = re.search(r"\n\n((?:// ?.*\n|//\n)+)\n", text)
    if match is None:
        return ""
    shown, in_code = [], False
    for line in (line[3:] for line in match[1].splitlines()):
        is_code = line.startswith("    ") and (in_code or shown[-1] == "")
        if is_code != in_code and line:
            shown += ["```cpp"] if is_code else ["```", ""]
            in_code = is_code
        if line.startswith(("Domain: ", "Errors: ", "Thread safety: ")):
            shown.append("")
        shown.append(line[4:] if is_code else line.strip())
    text = "\n".join(shown + ["```"] * in_code) + "\n"
    return re.sub(r"\n\n+(```\n)(?!cpp)", r"\n\1", re.sub(r"\n{3,}", "\n\n", text))


def page(folder):
    made = Page()
    for path in sorted(pathlib.Path(folder, "xml").glob("*.xml")):
        for compound in ElementTree.parse(path).getroot().findall("compounddef"):
            kind, name = compound.get("kind"), compound.findtext("compoundname")
            if kind in ("struct", "class") and name.startswith(("raycheck::", "raycheck_")):
                if compound.get("prot") == "public" and not name.endswith("::Impl"):
                    made.add(place(compound), made.of_class(compound))
            elif kind == "namespace" and name.startswith("raycheck"):
                for member in compound.findall("sectiondef/memberdef"):
                    is_enum = member.get("kind") == "enum"
                    made.add(place(member),
                             made.of_enum(member) if is_enum else made.of_function(member))
            elif kind == "file":
                for member in compound.findall("sectiondef/memberdef"):
                    if is_c(member.findtext("name")) and member.get("kind") in ("enum", "function"):
                        is_enum = member.get("kind") == "enum"
                        made.add(place(member),
                                 made.of_enum(member) if is_enum else made.of_function(member))
                for member in compound.findall("sectiondef/memberdef[@kind='define']"):
                    if not member.findtext("name").endswith("_H_"):
                        made.add(place(member), made.of_function(member))
    unknown = made.entries.keys() - set(ORDER)
    if unknown:
        sys.exit(f"add {sorted(unknown)} to ORDER of docs/api_page.py")
    text = TOP
    for header in ORDER:
        text += f"\n## `raycheck/{header}.h`\n\n{own_comment(header)}"
        for _, entry in sorted(made.entries.get(header, [])):
            text += "\n" + entry
    return text, made.unsaid


def main():
    check = sys.argv[1:] == ["--check"]
    if shutil.which("doxygen") is None:
        print("SKIPPED: doxygen is not installed")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["doxygen", "-"], cwd=folder, input=CONFIGURATION, text=True, check=True,
                       stdout=subprocess.DEVNULL)
        text, unsaid = page(folder)
    if unsaid:
        sys.exit("\n".join(unsaid))
    if check and (not PAGE.exists() or PAGE.read_text() != text):
        sys.exit("docs/api.md is stale: run python3 docs/api_page.py")
    if not check:
        PAGE.write_text(text)


main()
