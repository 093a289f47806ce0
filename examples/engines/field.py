"""Judges every engine of engines.toml that is installed.

    field.py RAYCHECK BUILD [--write DOCS] [--cases N] [NAME ...]

prints a table, and with --write makes DOCS/field.md and DOCS/field/NAME.md of the same run: what each breaks up to which
severity, with the smallest case, its exact answer, and a reproduction that needs no raycheck, which is run. An engine
whose package is missing is skipped by name. BUILD has examples/engines (libraries) and field/npm (node's engines).
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

HERE = pathlib.Path(__file__).parent
LEVELS = ("ordinary", "demanding", "extreme")
OWN = ("quadratic", "cross", "robust")
LAWS = {  # what a column counts, by law
    "class": "class", "growing-radius": "class", "nearest-root": "root", "parameter": "s",
    "backward-error": "s", "hit-point": "Q", "scaling": "scaling", "axes": "axes",
}
DIALS = {  # frontier columns: the source, how its severity reads, and its highest
    "distance": ("far", "10^{} radii", 15), "tangency": ("grazing", "10^-{} of r", 16),
    "scale": ("scale", "2^±{}", 1074), "surface": ("at the surface", "10^-{}", 16),
    "inside": ("inside", "10^-{} of r", 16), "far-world": ("off the origin", "10^{}", 15),
}


def words_of(engine, build):
    """What --candidate is given; None if it is not installed."""
    language, name = engine["language"], engine["name"]
    if language in ("c++", "c"):
        library = build / "examples/engines" / f"{name}.so"
        return f"library:{library}" if library.exists() else None
    if language == "javascript":
        module = build / "field/npm" / engine["adapter"]
        return f"command:node {module}" if module.exists() and version_of(engine, build) else None
    if not version_of(engine, build):
        return None
    files = [str(HERE / part) for part in engine["adapter"].split()]
    return "command:python3 " + " ".join(files)


def version_of(engine, build):
    """That of the package that is installed; empty: none is."""
    if engine["language"] == "javascript":
        package = build / "field/npm/node_modules" / engine["package"] / "package.json"
        return json.loads(package.read_text())["version"] if package.exists() else ""
    asked = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Abbrev}${Version}", engine["package"]],
                           capture_output=True, text=True)
    return asked.stdout[3:].strip() if asked.stdout.startswith("ii") else ""


class Raycheck:
    def __init__(self, program, cases):
        self.program, self.cases = program, cases

    def json(self, *words):
        asked = subprocess.run([self.program, *words, "--format", "json"], capture_output=True, text=True)
        if not asked.stdout:
            raise RuntimeError(asked.stderr.strip())
        return json.loads(asked.stdout)

    def judged(self, who, level):
        return self.json("properties", *who, "--level", level, "--cases", str(self.cases))["campaigns"]


def is_broken(part):
    return part["discrepancies_by_standing"]["defect"] > 0


def broken_at(campaigns, level):
    """What is broken at a level, in the order of LAWS; None: nothing was judged there."""
    found, judged = [], False
    for campaign in campaigns:
        what = LAWS.get(campaign["law"])
        for part in campaign["parts"]:
            if not what or part["level"] != level:
                continue
            judged = judged or part["comparisons"] > 0
            if is_broken(part) and what not in found:
                found.append(what)
    return found if judged else None


def frontier(campaigns, source):
    """Up to which severity class, root, s and Q hold at all that were tried; None: not judged there."""
    held, broken = None, math.inf
    for campaign in campaigns:
        if LAWS.get(campaign["law"]) not in ("class", "root", "s", "Q"):
            continue
        for part in campaign["parts"]:
            if part["source"].split("@")[0] != source or part["comparisons"] == 0:
                continue
            if is_broken(part):
                broken = min(broken, part["severity"])
            else:
                held = max(held if held is not None else -1, part["severity"])
    severities = sorted({part["severity"] for campaign in campaigns for part in campaign["parts"]
                         if part["source"].split("@")[0] == source and part["comparisons"] > 0
                         and LAWS.get(campaign["law"]) in ("class", "root", "s", "Q")})
    below = [severity for severity in severities if severity < broken]
    return below[-1] if below else (-1 if severities else None)


def mistake_of(campaigns):
    """The sentence that explains most of what is wrong, where one does."""
    best = max((one for campaign in campaigns for one in campaign["explanations"]),
               key=lambda one: one["explained"], default=None)
    return best["sentence"] if best else ""


def error_of(campaigns, name):
    for campaign in campaigns:
        for quantity in campaign["quantities"]:
            if quantity["name"] == name and quantity["measured"]:
                return quantity
    return None


def scene_numbers(scene):
    """o, d, c and r of a scene of one ray and one sphere; None for another."""
    parsed = tomllib.loads(scene)
    if len(parsed.get("ray", [])) != 1 or len(parsed.get("sphere", [])) != 1:
        return None
    ray, sphere = parsed["ray"][0], parsed["sphere"][0]
    origin, direction, centre = ray["origin"], ray["direction"], sphere["centre"]
    return dict(zip(("ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"),
                    map(float, [*origin, *direction, *centre, sphere["radius"]])))


def reproduction(engine, numbers, build):
    """The program that shows a case without raycheck, and what it prints when it is run."""
    text = engine["reproduction"]
    for name, value in numbers.items():
        text = text.replace("{" + name + "}", repr(value))
    with tempfile.TemporaryDirectory() as folder:
        if engine["language"] in ("c++", "c"):
            source = pathlib.Path(folder, "case." + ("cpp" if engine["language"] == "c++" else "c"))
            source.write_text(text)
            made = subprocess.run(["sh", "-c", f"{engine['compile']} {source} -o {folder}/case {engine.get('link', '')}"],
                                  capture_output=True, text=True)
            if made.returncode != 0:
                raise RuntimeError(f"{engine['name']}: its reproduction does not compile: {made.stderr[:300]}")
            run = [f"{folder}/case"]
        elif engine["language"] == "javascript":
            source = build / "field/npm" / f".case-{engine['name']}.mjs"
            source.write_text(text)
            run = ["node", str(source)]
        else:
            source = pathlib.Path(folder, "case.py")
            source.write_text(text)
            run = ["python3", str(source)]
        shown = subprocess.run(run, capture_output=True, text=True, timeout=60)
        if engine["language"] == "javascript":
            source.unlink()
    if shown.returncode != 0:
        raise RuntimeError(f"{engine['name']}: its reproduction fails: {shown.stderr[:300]}")
    return text.strip(), shown.stdout.strip()


class Page:
    """What one engine's page says."""

    def __init__(self, engine, raycheck, build):
        self.engine, self.name = engine, engine["name"]
        self.version = engine.get("version") or version_of(engine, build)
        who = ["--candidate", words_of(engine, build)] if "package" in engine else ["--intersect", self.name]
        self.ordinary = raycheck.judged(who, "ordinary")
        self.extreme = raycheck.judged(who, "extreme")
        self.breaks = {level: broken_at(self.ordinary if level == "ordinary" else self.extreme, level)
                       for level in LEVELS}
        self.frontiers = {source: frontier(self.extreme, source) for source in DIALS}
        self.mistake = mistake_of(self.ordinary) or mistake_of(self.extreme)
        self.error = error_of(self.ordinary, "parameter") or error_of(self.ordinary, "hit point")
        self.cases = self.smallest(raycheck, build)
        self.ratio = None

    def smallest(self, raycheck, build):
        """The smallest case of each kind that breaks, of the lowest level that does."""
        found = {}
        for campaign in self.ordinary + self.extreme:
            what = LAWS.get(campaign["law"])
            if not what or what in found or not campaign["scene"] or what in ("scaling", "axes"):
                continue
            numbers = scene_numbers(campaign["scene"])
            case = {"law": campaign["sentence"], "scene": campaign["scene"].strip(), "first": campaign["discrepancies"][0],
                    "replay": campaign["replay"], "level": campaign["level"]}
            if numbers:
                ray = ",".join(repr(numbers[k]) for k in ("ox", "oy", "oz", "dx", "dy", "dz"))
                sphere = ",".join(repr(numbers[k]) for k in ("cx", "cy", "cz", "r"))
                case["exact"] = raycheck.json("explain", f"--ray={ray}", f"--sphere={sphere}")["exact"]
                if "reproduction" in self.engine:
                    case["program"], case["prints"] = reproduction(self.engine, numbers, build)
            found[what] = case
        return found

    def cell(self, level):
        broken = self.breaks[level]
        return "-" if broken is None else "breaks " + ", ".join(broken) if broken else "holds"

    def frontier_text(self, source):
        held, (_, reading, highest) = self.frontiers[source], DIALS[source]
        if held is None:
            return "-"
        return "none" if held < 0 else "all" if held >= highest else reading.format(held)

    def row(self):
        error = self.error
        errors = f"{error['median']:.2g} / {error['max']:.3g} {error['unit']}" if error else "-"
        ratio = f"{self.ratio:.2g}" if self.ratio else "-"
        return ([f"[{self.engine['library']}](field/{self.name}.md)", f"`{self.engine['function']}`"]
                + [self.cell(level) for level in LEVELS] + [self.frontier_text(source) for source in DIALS]
                + [errors, ratio, self.mistake or ("right within its contract" if self.breaks["ordinary"] == [] else "-")])

    def text(self):
        engine = self.engine
        lines = [f"# {engine['library']}: `{engine['function']}`", "",
                 f"{engine.get('package', 'raycheck')} {self.version}, {engine['language']}. {engine['contract']} "
                 f"({engine['source']})", ""]
        lines += [f"- {level}: {self.cell(level)}" for level in LEVELS]
        lines += [f"- {title}: {self.frontier_text(source)}" for source, (title, _, _) in DIALS.items()]
        if self.mistake:
            lines += ["", f"What explains it: {self.mistake}."]
        if not any(self.breaks.values()):
            lines += ["", "Nothing that it promises was found broken."]
        for what, case in self.cases.items():
            lines += ["", f"## Breaks {what}", "", f"The law: {case['law']}. The smallest case found ({case['level']}):", "",
                      "```toml", case["scene"], "```", "", answer_text(case)]
            if "program" in case:
                lines += ["", "Without raycheck:", "", "```" + engine["language"], case["program"], "```", "",
                          "It prints:", "", "```text", case["prints"], "```"]
        return "\n".join(lines) + "\n"


def answer_text(case):
    first = case["first"]
    got = ", ".join(str(decimal(x)) for x in first["got"]) or "a miss"
    exact = case.get("exact")
    if not exact:
        return f"It answers {got}."
    if exact["class"] == "miss":
        return f"It answers {got}. The exact answer is a miss."
    s = exact["s"] and decimal(exact["s"])
    form = f", exactly {exact['closed_form']}" if exact.get("closed_form") else ""
    return f"It answers {got}. Exact: {exact['class']} at s = {s}{form}."


def decimal(number):
    return float.fromhex(number) if isinstance(number, str) and number.lstrip("-").startswith("0x") else number


def add_times(pages, raycheck, build):
    """Time a ray over that of `quadratic`, of those that can be called in process, in one run."""
    libraries = [page for page in pages if page.engine["language"] in ("c++", "c") and "package" in page.engine]
    words = [word for page in libraries for word in ("--candidate", words_of(page.engine, build))]
    found = raycheck.json("tradeoff", "--cases", "500", "--sandbox", "none", "--i-know", *words,
                          "--method", ",".join(OWN))["intersections"]
    ns = {one["name"]: (one["call"] or {}).get("median_ns") for one in found}
    base = ns.get("quadratic")
    for page in pages:
        own = ns.get(page.name if page.name in OWN else words_of(page.engine, build))
        page.ratio = own / base if own and base else None


def chart(pages, path):
    """Frontier of distance against time, a dot an engine: SVG by gnuplot."""
    dots = [(page.ratio, max(page.frontiers["distance"] or 0, 0), page.name) for page in pages
            if page.ratio and page.frontiers["distance"] is not None]
    rows = "\n".join(f'{ratio:.3g} {held} "{name}"' for ratio, held, name in dots)
    script = f"""set terminal svg size 900,560 font 'sans,12' background 'white'
set output '{path}'
set logscale x
set xlabel 'time a ray, over that of quadratic'
set ylabel 'right up to a distance of 10^k radii'
set yrange [-0.5:16]
set grid
$dots << EOD
{rows}
EOD
plot $dots using 1:2 with points pt 7 ps 0.8 notitle, $dots using 1:2:3 with labels offset 0,0.7 font ',9' notitle
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


HEAD = (["library", "function"] + list(LEVELS) + [title for title, _, _ in DIALS.values()]
        + ["s on ordinary cases: median / worst", "time", "what is wrong"])


def table(pages):
    return "\n".join("| " + " | ".join(row) + " |" for row in
                     [HEAD, ["---"] * len(HEAD)] + [page.row() for page in pages])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("raycheck", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path, metavar="DOCS")
    parser.add_argument("--cases", type=int, default=1000)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    raycheck = Raycheck(options.raycheck, options.cases)
    engines = tomllib.loads((HERE / "engines.toml").read_text())["engine"]
    unknown = set(options.names) - {engine["name"] for engine in engines} - set(OWN)
    if unknown:
        sys.exit(f"field: no such engine: {', '.join(sorted(unknown))}")
    own = [{"name": name, "library": "raycheck", "function": name, "language": "c++", "contract": "", "source": "docs/api.md",
            "version": "this"} for name in OWN]
    chosen = [engine for engine in own + [e for e in engines if e.get("taken", True)]
              if not options.names or engine["name"] in options.names]
    skipped = [engine["name"] for engine in chosen if "package" in engine and not words_of(engine, options.build)]
    chosen = [engine for engine in chosen if engine["name"] not in skipped]
    pages, failed = [], []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = {pool.submit(Page, engine, raycheck, options.build): engine["name"] for engine in chosen}
        for done, job in enumerate(concurrent.futures.as_completed(jobs), 1):
            print(f"\r{done} of {len(jobs)} judged", end="", file=sys.stderr)
            try:
                pages.append(job.result())
            except (RuntimeError, subprocess.TimeoutExpired) as error:
                failed.append(f"{jobs[job]}: {error}")
    print(file=sys.stderr)
    order = [engine["name"] for engine in chosen]
    pages.sort(key=lambda page: order.index(page.name))
    add_times(pages, raycheck, options.build)
    for name in skipped:
        print(f"skipped: {name}: not installed", file=sys.stderr)
    print(table(pages))
    if options.write and not failed:
        folder = options.write / "field"
        folder.mkdir(exist_ok=True)
        for old in folder.glob("*.md"):
            old.unlink()
        for page in pages:
            (folder / f"{page.name}.md").write_text(page.text())
        chart(pages, folder / "frontier.svg")
        text = (options.write / "field.in.md").read_text()
        not_taken = "\n".join(f"- {e['library']} (`{e['package']}`): {e['reason']}" for e in engines if not e.get("taken", True))
        (options.write / "field.md").write_text(text.replace("{table}", table(pages)).replace("{not taken}", not_taken))
    sys.exit("\n".join(f"field: {line}" for line in failed) if failed else 0)


if __name__ == "__main__":
    main()
