"""Judges every engine of engines.toml that is installed.

    field.py RAYCHECK BUILD [--write DOCS] [--cases N] [NAME ...]

prints a table. With --write it makes DOCS/field.md and DOCS/field/NAME.md from the same run: the kinds of answers that are
wrong for each engine, the severity up to which they are right, and the smallest cases, each with its exact answer and a
reproduction without raycheck, which is run; with names, the pages and rows of other engines stay as they are, and so do
those of an engine that fails. Engines whose package is missing are listed and skipped. BUILD contains examples/engines (libraries) and field/npm (node).
"""
import argparse
import concurrent.futures
import fractions
import json
import math
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import tomllib

from tables import FRONTIERS, LEVELS, kind_of, line, table, write

REPRODUCTION_SECONDS = 1800  # a backstop: a reproduction takes seconds, on a busy machine minutes
HERE = pathlib.Path(__file__).parent
OWN = ("quadratic", "cross", "robust")
LANGUAGES = {"c++": "C++", "c": "C", "javascript": "JavaScript", "python": "Python", "glsl": "GLSL", "opencl": "OpenCL",
             "gdscript": "GDScript", "haskell": "Haskell", "java": "Java", "octave": "Octave"}
LAWS = {  # by law: the kind of answer that a column shows
    "class": "class", "growing-radius": "class", "exchange": "class", "nearest-root": "root", "parameter": "s",
    "backward-error": "s", "hit-point": "Q", "scaling": "scaling", "axes": "axes", "image": "picture",
}
ANSWERS = ("class", "root", "s", "Q", "picture")  # the kinds that frontiers depend on
KEEPS_STATE = "the candidate keeps state between questions"
AGREES = {"double": 1e-14, "single": 1e-6}  # relative: what a reproduction prints, and the candidate's answer


def words_of(engine, build):
    """The arguments after --candidate; empty if the engine is not installed."""
    if not version_of(engine, build):
        return []
    if "command" not in engine:
        library = build / "examples/engines" / f"{engine['name']}.so"
        return [f"library:{library}"] if library.exists() else []
    field = build / "field"
    words = [str(field / word) if "/" in word else word for word in engine["command"].split()] + [str(field / engine["adapter"])]
    words += engine.get("arguments", "").split()
    kind = "renderer" if engine.get("renders") else "command"
    return [f"{kind}:" + " ".join(words), "--read", str(field), *shlex.split(engine.get("options", ""))]


def version_of(engine, build):
    """The version of the installed package; empty if it is not installed."""
    if "package" not in engine:
        return "in its usual form"
    if engine.get("prints_version"):
        program = [*engine["command"].split(), build / "field" / engine["adapter"]]
        return subprocess.run(program, capture_output=True, text=True).stdout.strip()
    package = build / "field/npm/node_modules" / engine["package"] / "package.json"
    if package.exists():
        return json.loads(package.read_text())["version"]
    asked = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Abbrev}${Version}", engine["package"]],
                           capture_output=True, text=True)
    return asked.stdout[3:].strip() if asked.stdout.startswith("ii") else ""


class Raycheck:
    def __init__(self, program, cases):
        self.program, self.cases = program, cases

    def json(self, *words):
        asked = subprocess.run([str(self.program.resolve()), *words, "--format", "json"], capture_output=True, text=True)
        if not asked.stdout:
            raise RuntimeError(asked.stderr.strip())
        return json.loads(asked.stdout)

    def judged(self, who, level, cases):
        return self.json("properties", *who, "--level", level, "--cases", str(min(cases, self.cases)))["campaigns"]


def is_broken(part):
    return part["discrepancies_by_standing"]["defect"] > 0


def broken_at(campaigns, level):
    """The kinds of answers that are broken at a level, in the order of LAWS; None: nothing was judged."""
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
    """The largest severity up to which class, root, s and Q are right at every severity tried: inf if they are at all, -1 if
    not at the first; None: not judged."""
    broken = math.inf
    for campaign in campaigns:
        if LAWS.get(campaign["law"]) not in ANSWERS:
            continue
        for part in campaign["parts"]:
            if part["source"].split("@")[0] != source or part["comparisons"] == 0:
                continue
            if is_broken(part):
                broken = min(broken, part["severity"])
    severities = sorted({part["severity"] for campaign in campaigns for part in campaign["parts"]
                         if part["source"].split("@")[0] == source and part["comparisons"] > 0
                         and LAWS.get(campaign["law"]) in ANSWERS})
    below = [severity for severity in severities if severity < broken]
    if not severities:
        return None
    return math.inf if math.isinf(broken) else below[-1] if below else -1


def mistake_of(campaigns, refuted):
    """The sentence that explains most wrong answers, among those that are not refuted."""
    best = max((one for campaign in campaigns for one in campaign["explanations"] if one["sentence"] not in refuted),
               key=lambda one: one["explained"], default=None)
    return best["sentence"] if best else ""


def facts_of(campaigns):
    """What no verdict depends on, in words: how exact tangents and hits at s = 0 are answered."""
    tangents, missed, at_zero = (sum(campaign[name] for campaign in campaigns)
                                 for name in ("tangents", "tangents_missed", "missed_at_zero"))
    share = f"all {missed}" if missed == tangents > 1 else f"{missed} of {tangents}"
    return "; ".join([f"takes {share} exact tangents for misses"] * (missed > 0)
                     + [f"misses {at_zero} {'hit' if at_zero == 1 else 'hits'} at s = 0 exactly"] * (at_zero > 0))


def error_of(campaigns, name):
    for campaign in campaigns:
        for quantity in campaign["quantities"]:
            if quantity["name"] == name and quantity["measured"]:
                return quantity
    return None


def scene_numbers(scene, pixel):
    """The numbers of a scene of one sphere and one ray, or a camera's pixel; None for other scenes."""
    parsed = tomllib.loads(scene)
    if len(parsed.get("sphere", [])) != 1:
        return None
    sphere = parsed["sphere"][0]
    if "camera" in parsed and pixel:
        camera = parsed["camera"]
        numbers = dict(zip(("ex", "ey", "ez", "ax", "ay", "az", "ux", "uy", "uz", "cx", "cy", "cz"),
                           map(float, [*camera["eye"], *camera["look_at"], *camera["up"], *sphere["centre"]])))
        numbers |= {name: float(camera[name]) for name in ("left", "right", "bottom", "top")}
        return numbers | {"near": -float(camera["near"]), "width": camera["width"], "height": camera["height"], "i": pixel[0], "j": pixel[1], "r": float(sphere["radius"])}
    if len(parsed.get("ray", [])) != 1:
        return None
    ray = parsed["ray"][0]
    origin, direction, centre = ray["origin"], ray["direction"], sphere["centre"]
    return dict(zip(("ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"),
                    map(float, [*origin, *direction, *centre, sphere["radius"]])))


def reproduction(engine, numbers, build, may_fail):
    """The kind, the text and the output of a program that shows a case without raycheck; the output is its error if the
    engine fails. None if the engine has no template."""
    templates = sorted((HERE / "reproductions").glob(engine.get("of", engine["name"]) + ".*"))
    if not templates:
        return None
    text = templates[0].read_text()
    for name, value in numbers.items():
        text = text.replace("{" + name + "}", repr(value))
    kind = templates[0].suffix
    # Beside node_modules, if it exists, since reproductions also read the shaders of its packages.
    npm = (build / "field/npm").resolve()
    folder = pathlib.Path(tempfile.mkdtemp(dir=npm if npm.exists() else None))
    try:
        source = folder / f"case{kind}"
        source.write_text(text)
        run = {".mjs": f"node {engine.get('command', 'node')[5:]} case.mjs", ".py": f"/usr/bin/python3 {source}"}.get(kind)
        # The first line of another program contains the command that runs it, or compiles it.
        first = text.splitlines()[0].strip("/*%#- ")
        run = run or first + (" && ./case" if "-o case" in first else "")
        shown = subprocess.run(["sh", "-c", run], cwd=npm if kind == ".py" and npm.exists() else folder, capture_output=True,
                               text=True, timeout=REPRODUCTION_SECONDS)
    finally:
        shutil.rmtree(folder)
    if shown.returncode != 0 and not may_fail:
        raise RuntimeError(f"its reproduction fails: {shown.stderr[-300:]}")
    ends = [line for line in shown.stderr.splitlines() if "terminate called" in line or "rror" in line]
    return kind[1:], text.strip(), ends[0].strip() if shown.returncode != 0 and ends else shown.stdout.strip()


def right_as_printed(case, numbers, tolerance):
    """The right output of a reproduction, in the form in which it prints (a miss, a hit, s or a distance, or a point); empty
    if unknown. Raises RuntimeError if the reproduction does not print what the candidate answered."""
    prints, first = case["reproduction"][2], case["first"]
    words, got = prints.split(), [float(decimal(x)) for x in first["got"]]
    exact = [float(decimal(x)) for x in first["exact"]]
    wrong = RuntimeError(f"its reproduction prints {prints}, but it answered {first['got']}")
    is_of_pixel = "ex" in numbers
    origin, direction = ([numbers.get(axis + k, 0) for k in "xyz"] for axis in "od")
    length = math.hypot(*direction)
    point = lambda s: [o + s * d for o, d in zip(origin, direction)]
    ways = {1: [lambda s: [s], lambda s: [s * length]], 3: [point]}  # s, a distance, a point
    if len(got) == 3 and not is_of_pixel:
        along = lambda Q: sum((q - o) * (d / length) for q, o, d in zip(Q, origin, direction))
        ways = {1: [lambda Q: [along(Q) / length], lambda Q: [along(Q)]], 3: [lambda Q: Q]}
    if words[:1] in (["miss"], ["hit"]) or not got:
        if (words[:1] == ["miss"]) != (not got):
            raise wrong
        return "a miss" if not exact else "a hit" if words[:1] == ["hit"] else ""
    printed = [float(word) for word in words]
    if is_of_pixel:  # the ray, from which a point follows, is unknown
        ways = {1: [lambda s: [s]], 3: [lambda Q: Q]}
        if len(printed) != len(got):
            return "" if exact else "a miss"
    size = max(map(abs, [*origin, *printed]))
    for way in ways[len(printed)]:
        # NaNs agree.
        if all(abs(x - y) <= tolerance * size or x != x for x, y in zip(printed, way(got if len(got) == 3 else got[0]))):
            if is_residual(first):
                return ""
            return " ".join(f"{x:.17g}" for x in way(exact if len(exact) == 3 else exact[0])) if exact else "a miss"
    raise wrong


def power_of_two(number):
    return f"2^{math.log2(number):.0f}"


def is_residual(first):
    return "residual" in first["quantity"]


class Page:
    """The page of an engine."""

    def __init__(self, engine, raycheck, build):
        self.engine, self.name = engine, engine["name"]
        self.version = engine.get("version") or version_of(engine, build)
        who = ["--intersect", self.name] if self.name in OWN else ["--candidate", *words_of(engine, build)]
        most = engine.get("cases", raycheck.cases)
        self.ordinary = raycheck.judged(who, "ordinary", most)
        self.extreme = raycheck.judged(who, "extreme", most)
        self.breaks = {level: broken_at(self.ordinary if level == "ordinary" else self.extreme, level)
                       for level in LEVELS}
        self.frontiers = {source: frontier(self.extreme, source) for source in FRONTIERS}
        self.judged = least, most = [float(decimal(x)) for x in self.ordinary[0]["lengths"]]
        self.lengths = f"lengths from {power_of_two(least)} to {power_of_two(most)}" if least > 2**-959 or most < 2**1023 else ""
        refuted = engine.get("refuted", [])
        self.mistake = mistake_of(self.ordinary, refuted) or mistake_of(self.extreme, refuted)
        self.facts = facts_of(self.ordinary)
        self.error = error_of(self.ordinary, "parameter") or error_of(self.ordinary, "hit point")
        self.cases = self.smallest(raycheck, build)
        self.class_alone = any("only hit or miss" in (one["reason_left_out"] or "") for one in self.ordinary)
        self.ratio = None
        self.title = self.name  # of its page
        self.others = []  # pages of its other readings, none milder

    def harm(self):
        """The number of broken kinds of answers, by level."""
        return [len(self.breaks[level] or []) for level in LEVELS]

    def smallest(self, raycheck, build):
        """The smallest case of each broken kind, from the lowest level at which it breaks."""
        found = {}
        for campaign in self.ordinary + self.extreme:
            what = LAWS.get(campaign["law"])
            if not what or what in found or campaign["finding"] != "broken" or what in ("scaling", "axes"):
                continue
            if not campaign["discrepancies"]:
                if any(KEEPS_STATE in one["sentence"] for one in campaign["explanations"]):
                    continue  # no single case shows it
                raise RuntimeError(f"{campaign['law']}: broken, but its smallest case shows no wrong answer: {campaign['scene']}")
            numbers = scene_numbers(campaign["scene"], campaign["discrepancies"][0]["pixel"])
            part = next(part for part in campaign["parts"] if part["replay"] == campaign["replay"])
            severity = "" if part["severity"] is None else f"@{part['severity']}"
            case = {"law": campaign["sentence"], "scene": campaign["scene"].strip(), "first": campaign["discrepancies"][0], "precision": campaign["precision"],
                    "level": part["level"], "source": part["source"].split("@")[0] + severity}
            if numbers:
                case["numbers"] = numbers
                if "ox" in numbers:
                    ray = ",".join(repr(numbers[k]) for k in ("ox", "oy", "oz", "dx", "dy", "dz"))
                    sphere = ",".join(repr(numbers[k]) for k in ("cx", "cy", "cz", "r"))
                    case["exact"] = raycheck.json("explain", f"--ray={ray}", f"--sphere={sphere}")["exact"]
                case["reproduction"] = reproduction(self.engine, numbers, build, case["first"]["failed"] is not None)
                if case["reproduction"]:
                    case["right"] = "" if case["first"]["failed"] else right_as_printed(case, numbers, AGREES[campaign["precision"]])
            found[what] = case
        return found

    def cell(self, level):
        broken = self.breaks[level]
        return "-" if broken is None else "breaks " + ", ".join(broken) if broken else "holds"

    def frontier_text(self, source):
        held, (_, reading) = self.frontiers[source], FRONTIERS[source]
        if held is None:
            return "-"
        if source == "scale" and 0 < held < 1000 and self.judged[0] > 2.0**-held:
            reading = "2^{} (no smaller lengths are judged)"
        return "none" if held < 0 else "1" if held == 0 else "all" if math.isinf(held) else reading.format(held)

    def row(self):
        error = self.error
        errors = f"{float(error['median']):.2g} / {float(error['max']):.3g} {error['unit']}" if error else "-"
        ratio = f"{self.ratio:.2g}" if self.ratio else "-"
        return ([f"[{self.engine['library']}](field/{self.title}.md)", f"`{self.engine['function']}`"]
                + [self.cell(level) for level in LEVELS] + [self.frontier_text(source) for source in FRONTIERS]
                + [errors, ratio, self.said()])

    def said(self):
        """The most important finding, in one sentence."""
        right = "right within its contract" if not any(self.breaks.values()) else ""
        if right and self.engine.get("renders"):
            pictures = sum(campaign["cases"] for campaign in self.extreme if campaign["law"] == "image")
            right = f"right in {pictures} pictures"
        if not right and not self.breaks["ordinary"]:
            right = "right on ordinary cases"
        lost = "in its rounded coefficients " if self.engine.get("solver") and self.mistake else ""
        return "; ".join(filter(None, [right, lost + self.mistake])) or "-"

    def origin(self):
        """Where the function comes from, and its contract."""
        engine = self.engine
        language = LANGUAGES.get(engine["language"], engine["language"])
        if self.name in OWN:
            return f"A method of raycheck, in {language}."
        where = "A common form of this function, written for this comparison."
        if "package" in engine:
            where = f"Package: {engine['package']} {self.version}."
        source = f" Source: {engine['source']}." if "package" in engine else ""
        return f"{where} Language: {language}. Contract (it takes; it returns; other terms): {engine['contract']}.{source}"

    def text(self):
        engine = self.engine
        lines = [f"# {engine['library']}: `{engine['function']}`", "",
                 self.origin() + (f" Judged on {self.lengths}." if self.lengths else ""), "",
                 "The wrong answers, by level; each line has only the cases of that level (the laws [scaling and axes](../laws.md) are listed, but not illustrated below):", ""]
        lines += [f"- {level}: {self.cell(level)}" for level in LEVELS]
        texts = {source: self.frontier_text(source) for source in FRONTIERS}
        off = {"tangency": " r from tangency", "inside": " r from the centre"}
        if set(texts.values()) != {"-"}:
            lines += ["", "The hardest severity up to which class, root, s and Q are right (for *grazing*, the distance of rays from tangency; cases of other sources are not in this list):", ""]
            lines += [f"- {title}: {'only the mildest' if texts[source] == '1' else texts[source].replace(' of r', off.get(source, ''))}" for source, (title, _) in FRONTIERS.items()]
        if self.mistake:
            lines += ["", f"The mistake that explains most wrong answers: {self.mistake}."]
        if self.facts:
            lines += ["", f"On ordinary cases it {self.facts}; no verdict depends on that."]
        if self.others:
            lines += ["", f"Its documentation does not say {engine['silent']}. This page assumes that {engine['reading']}."]
            lines += [f"If {other.engine['reading']}, the verdict is not milder: ordinary: {other.cell('ordinary')}; "
                      f"demanding: {other.cell('demanding')}; extreme: {other.cell('extreme')}." for other in self.others]
        if "note" in engine:
            lines += ["", f"Note: {engine['note']}."]
        if not any(self.breaks.values()):
            lines += ["", "Everything that it promises was found to hold."]
        for what, case in self.cases.items():
            lines += ["", f"## Breaks {what}", "", f"The law: {case['law']}. The smallest case found ({case['level']}, {case['source']}):", "",
                      "```toml", case["scene"], "```", "", answer_text(case, self.class_alone)]
            if case.get("reproduction"):
                kind, program, prints = case["reproduction"]
                lines += ["", "Without raycheck:", "", f"```{kind}", program, "```", "", printed_text(prints, case["first"], case["numbers"]), "", "```text", prints, "```"]
                if case["right"]:
                    lines += ["", f"The right result is: {case['right']}."]
        return "\n".join(lines) + "\n"


def printed_text(prints, first, numbers):
    """The line above the output of a reproduction. A single number is s, or the distance, whichever is nearer to the answer."""
    if len(prints.split()) != 1 or prints in ("miss", "hit") or not first["got"] or "ex" in numbers:
        return "It prints:"
    length, got = math.hypot(*(numbers[k] for k in ("dx", "dy", "dz"))), [float(decimal(x)) for x in first["got"]]
    clearly = 1
    if first["symbol"] == "Q":
        got, clearly = [math.dist(got, [numbers[k] for k in ("ox", "oy", "oz")]) / length], 1000
    off = [abs(abs(float(prints)) - abs(value)) for value in (got[0], got[0] * length)]
    return "It prints the distance (s times the length of the direction):" if clearly * off[1] < off[0] else "It prints s:"


def answer_text(case, class_alone):
    """The wrong answer, and the right one under the conventions that the engine declares."""
    first, exact = case["first"], case.get("exact", {})
    got = ", ".join(str(decimal(x)) for x in first["got"])
    right = ", ".join(str(decimal(x)) for x in first["exact"])
    of = {"s": "s = ", "Q": "Q = "}.get(first["symbol"], "")
    if first["failed"]:
        return "It fails: " + re.sub(r"/\S*/field/", "", first["what"]) + "."  # without folders of this machine
    if is_residual(first):
        off = {"sphere residual": "the sphere", "ray residual": "the ray"}[first["quantity"]]
        return f"Its answer is {of}{got}, which is off {off} by {first['error']:.3g} {first['unit']}."
    answers = "a hit" if got and class_alone else of + got if got else "a miss"
    if got and not right and first["symbol"] == "s" and not class_alone:
        answers = "a hit at " + answers
    exactly = "a hit" if right and class_alone else of + right if right else "a miss"
    form = exact.get("closed_form") if first["exact"] == [exact.get("s")] and not class_alone else None
    if not right or class_alone or form and "sqrt" not in form and fractions.Fraction(form) == decimal(first["exact"][0]):
        return f"Its answer is {answers}. The exact answer is {exactly}."
    rounded = {"single": "float", "double": "double"}[case["precision"]]
    return (f"Its answer is {answers}. The exact answer, rounded to {rounded}, is {exactly}"
            + (f"; without rounding it is {form}." if form else "."))


def decimal(number):
    return float.fromhex(number) if isinstance(number, str) and number.lstrip("-").startswith("0x") else number


def mildest(pages):
    """One page for each engine: the reading under which it breaks least, with the pages of its other readings in `others`."""
    readings = {}
    for page in pages:
        readings.setdefault(page.engine.get("of", page.name), []).append(page)
    kept = []
    for name, ones in readings.items():
        ones.sort(key=Page.harm)
        ones[0].others, ones[0].title = ones[1:], name
        kept.append(ones[0])
    return kept


def add_times(pages, raycheck, build):
    """Sets the time for a ray, divided by that of `quadratic`, of engines that can be called in process; one run times all."""
    libraries = [page for page in pages if page.engine["language"] in ("c++", "c")
                 and not page.engine.get("picks") and "command" not in page.engine]
    if not libraries:
        return
    words = [word for page in libraries if page.name not in OWN for word in ("--candidate", words_of(page.engine, build)[0])]
    found = raycheck.json("tradeoff", "--cases", "500", "--sandbox", "none", "--i-know", *words,
                          "--method", ",".join(OWN))["intersections"]
    ns = {one["name"]: (one["call"] or {}).get("median_ns") for one in found}
    base = ns.get("quadratic")
    for page in pages:
        own = ns.get(page.name if page.name in OWN else words_of(page.engine, build)[0])
        page.ratio = own / base if own and base else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("raycheck", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path, metavar="DOCS")
    parser.add_argument("--cases", type=int, default=500)
    parser.add_argument("names", nargs="*")
    options = parser.parse_intermixed_args()
    raycheck = Raycheck(options.raycheck, options.cases)
    engines = tomllib.loads((HERE / "engines.toml").read_text())["engine"]
    engines = [{"name": name, "library": "raycheck", "function": name, "language": "c++", "contract": "", "source": "docs/api.md",
            "version": "this"} for name in OWN] + engines
    unknown = set(options.names) - {engine["name"] for engine in engines}
    if unknown:
        sys.exit(f"field: no such engine: {', '.join(sorted(unknown))}")
    named = {engine.get("of", engine["name"]) for engine in engines if engine["name"] in options.names}  # with all readings
    chosen = [engine for engine in engines
              if engine.get("taken", True) and (not named or engine.get("of", engine["name"]) in named)]
    skipped = [engine["name"] for engine in chosen if engine["name"] not in OWN and not words_of(engine, options.build)]
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
    pages = mildest(pages)
    add_times(pages, raycheck, options.build)
    for name in skipped:
        print(f"skipped: {name}: not installed", file=sys.stderr)
    shown = sum(bool(case.get("reproduction")) for page in pages for case in page.cases.values())
    print(f"reproductions that were run and print the answers of their engines: {shown}", file=sys.stderr)
    print(table(line(page.row()) for page in sorted(pages, key=lambda page: kind_of(page.engine))))
    if options.write:
        write(pages, engines, options.write, bool(options.names or failed))
    sys.exit("\n".join(f"field: {reason}" for reason in failed) if failed else 0)


if __name__ == "__main__":
    main()
