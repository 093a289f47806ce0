"""What raycheck says, in one listing, and turns that engineers do not use, counted.

    python3 tests/words/words.py            writes tests/words/messages.txt, and lowers ceilings
    python3 tests/words/words.py --check    exits with 1 where the listing is stale, or where a turn
                                            is used more often than tests/words/turns.txt allows
"""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parent.parent
PRODUCT = ("reference/", "fast/", "properties/", "tools/", "scene/", "library/", "include/")
SUFFIXES = {".cpp", ".h", ".hpp", ".c", ".py", ".js", ".mjs", ".java", ".m", ".md", ".txt"}
TOKENS = re.compile(
    r'R"(?P<delimiter>\w*)\((?P<raw>.*?)\)(?P=delimiter)"'
    r'|"(?P<string>(?:[^"\\\n]|\\.)*)"'
    r"|'(?:[^'\\\n]|\\.)*'|//[^\n]*|/\*.*?\*/|(?P<other>[^\s])",
    re.DOTALL)
SENTENCE = re.compile(r"[A-Za-z}'),;:] [A-Za-z{(']")


def files():
    tops = [ROOT / top for top in (*PRODUCT, "proofs/", "tests/", "docs/", "examples/")]
    found = [file for top in tops for file in top.rglob("*")] + list(ROOT.glob("*.md"))
    return sorted(str(file.relative_to(ROOT)) for file in found if file.suffix in SUFFIXES)


def messages_of(text):
    """The string literals that read as sentences; adjacent literals are one."""
    found, open_literal = [], None
    for token in TOKENS.finditer(text):
        literal = token["string"]
        if literal is not None:
            open_literal = (open_literal or "") + literal
        elif token["other"] is not None:
            found.append(open_literal)
            open_literal = None
    return [one for one in found if one and SENTENCE.search(one)]


def listing():
    parts = []
    for name in files():
        if name.startswith(PRODUCT) and name.endswith((".cpp", ".h", ".hpp")):
            found = messages_of((ROOT / name).read_text())
            if found:
                parts.append("\n".join([name, *("    " + one for one in found)]))
    return "\n\n".join(parts) + "\n"


def counts():
    """How often each turn is used in code, tests and documentation."""
    texts = [
        re.sub(r"\s*\n\s*(///?|#|\*)?\s*", " ", (ROOT / name).read_text(errors="replace"))
        for name in files()
        if not name.startswith("tests/words/")
    ]
    return {
        turn: sum(len(re.findall(pattern, text)) for text in texts)
        for turn, pattern in TURNS.items()
    }


TURNS = {
    "so many, so much": r"\b[Ss]o (many|much)\b",
    "is none, are none": r"(?<!\b[Tt]here )\b(is|are) none\b",
    "is no X": r"(?<!\b[Tt]here )\bis no\b(?! longer\b)",
    "Who ...": r"(^|[.!?;:] )Who(m|se)? [a-z]",
    "whoever": r"\b[Ww]ho(m)?ever\b",
    "nobody": r"\b[Nn]obody\b",
    "said of, told of, asked of, speaks of": r"\b(said|told|asked|[Ss]peaks?) of\b",
    "alone, for only": r"\balone\b(?! =|->|\()",
    "sees": r"\b[Ss]ees\b",
    "of its own, of their own, of others": r"\bof (its own|their own|others)\b",
    "every how many": r"\b[Ee]very how many\b",
    "which is none, that is none": r"\b(which|that) is none\b",
    "dull": r"\b[Dd]ull\b",
    "rung": r"\b[Rr]ungs?\b",
    "examinee": r"\b[Ee]xaminees?\b",
}


def ceilings():
    lines = (HERE / "turns.txt").read_text().splitlines()
    return {turn: int(count) for count, turn in (line.split(" ", 1) for line in lines)}


def main(arguments):
    kept = HERE / "messages.txt"
    now = counts()
    if "--check" not in arguments:
        kept.write_text(listing())
        known = ceilings() if (HERE / "turns.txt").exists() else now
        lowest = {turn: min(count, known.get(turn, count)) for turn, count in now.items()}
        lines = [f"{count} {turn}\n" for turn, count in lowest.items()]
        (HERE / "turns.txt").write_text("".join(lines))
        return 0
    is_fresh = kept.read_text() == listing()
    if not is_fresh:
        print(f"{kept.relative_to(ROOT)} is stale: run `python3 tests/words/words.py`")
    allowed = ceilings()
    above = {turn: count for turn, count in now.items() if count > allowed.get(turn, 0)}
    for turn, count in above.items():
        print(f'"{turn}" is used {count} times, {allowed.get(turn, 0)} are allowed: '
              "`git grep` it, and write the noun")
    return 0 if is_fresh and not above else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
