"""The tables of docs/field.md, and its files."""
import math
import re

LEVELS = ("ordinary", "demanding", "extreme")
FRONTIERS = {  # frontier columns: by source, the title and the format of a severity
    "distance": ("far", "10^{} radii"), "tangency": ("grazing", "10^-{} of r"), "scale": ("scale", "2^±{}"),
    "surface": ("at the surface", "10^-{}"), "inside": ("inside", "10^-{} of r"), "far-world": ("off the origin", "10^{}"),
}
HEAD = (["library", "function"] + list(LEVELS) + [title for title, _ in FRONTIERS.values()]
        + ["error on ordinary cases: median / worst", "time", "what is wrong"])

KINDS = {"": "table", "solver": "solvers", "picks": "picks"}  # of engines: their key in engines.toml, and their table


def kind_of(engine):
    return next(kind for kind in [*list(KINDS)[1:], ""] if not kind or engine.get(kind))


def chart(rows, path):
    """An SVG chart with a dot for each engine: the distance up to which it is right, against its time for a ray."""
    dots = []
    for name, row in rows.items():
        cells = dict(zip(HEAD, row.strip("| ").split(" | ")))
        if "-" not in (cells["time"], cells["far"]):
            power = re.match(r"10\^(\d+)", cells["far"])
            dots.append((float(cells["time"]), int(power[1]) if power else 15 * (cells["far"] == "all"), name))
    if not dots:
        return
    least, most = (math.log10(choose(ratio for ratio, _, _ in dots)) for choose in (min, max))
    across = lambda ratio: 70 + 780 * (math.log10(ratio) - least) / max(most - least, 1e-9)
    up = lambda held: 500 - 28 * held
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 960 560" font-family="sans-serif" font-size="11">',
             '<rect width="960" height="560" fill="white"/>']
    for held in range(0, 16, 5):
        lines.append(f'<path d="M60 {up(held)}H930" stroke="#ccc"/><text x="22" y="{up(held) + 4}">10^{held}</text>')
    for power in range(math.ceil(least), math.floor(most) + 1):
        x = across(10 ** power)
        lines.append(f'<path d="M{x:.0f} 60V510" stroke="#ccc"/><text x="{x:.0f}" y="526">{10 ** power:g}</text>')
    lines += ['<text x="330" y="550">time per ray / that of quadratic</text>',
              '<text x="22" y="40">right up to this distance, in radii</text>']
    stacked = {}
    for ratio, held, name in sorted(dots):
        below = stacked.setdefault((round(across(ratio) / 90), held), [0])
        y = up(held) - 11 * below[0]
        below[0] += 1
        lines.append(f'<circle cx="{across(ratio):.0f}" cy="{up(held)}" r="3"/><text x="{across(ratio) + 5:.0f}" y="{y - 3}">{name}</text>')
    path.write_text("\n".join(lines) + "\n</svg>\n")


def line(cells):
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def table(rows):
    return "\n".join([line(HEAD), line(["---"] * len(HEAD)), *rows])


def rows_of(text):
    """The rows of a page's tables, by the names of the engines."""
    return {row[1]: row[0] for row in re.finditer(r"^\| \[[^]]*\]\(field/([^)]+)\.md\).*", text, re.M)}


def write(pages, engines, docs, others):
    """Writes docs/field.md, in the order of `engines`, and docs/field/NAME.md; if `others`, the other pages and rows stay."""
    folder = docs / "field"
    folder.mkdir(exist_ok=True)
    rows = {page.title: line(page.row()) for page in pages}
    if others and (docs / "field.md").exists():
        rows = rows_of((docs / "field.md").read_text()) | rows
    taken = [engine for engine in engines if engine.get("taken", True) and engine["name"] in rows]
    by_kind = {kind: {engine["name"]: rows[engine["name"]] for engine in taken if kind_of(engine) == kind} for kind in KINDS}
    for old in folder.glob("*.md"):
        if not others or not any(old.stem in ones for ones in by_kind.values()):
            old.unlink()
    for page in pages:
        (folder / f"{page.title}.md").write_text(page.text())
    chart(by_kind[""] | by_kind["solver"], folder / "frontier.svg")
    not_taken = "\n".join(f"- {e['library']} (`{e.get('package', '-')}`)" + (f", `{e['function']}`" if e.get("function") else "") + f": {e['reason']}" for e in engines if not e.get("taken", True))
    text = (docs / "field.in.md").read_text().replace("{not taken}", not_taken)
    for kind, name in KINDS.items():
        text = text.replace("{" + name + "}", table(by_kind[kind].values()))
    (docs / "field.md").write_text(text)
