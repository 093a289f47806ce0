#!/usr/bin/env python3
"""Writes the documents that contain the output of commands.

    python3 docs/generate.py            docs/error-against-run-time.md, from its template, and its
                                        pictures, with a headless Chromium (docs/pictures.py)
    python3 docs/generate.py --worst-cases [SEARCHES]    docs/worst-cases, with the release build
    python3 docs/generate.py --shown    the console blocks of README.md and the other documents
    python3 docs/generate.py --lists [PROGRAM] [--check]
                                        the marked parts of docs/laws.md, from the output of `list` of
                                        the program (default: ./run), and of docs/packages.md, from
                                        packages.txt; --check writes nothing and exits with 1 if a
                                        page is stale
    python3 docs/generate.py --performance
                                        docs/performance.md and its plot, with gnuplot, from a run
                                        of the benchmarks
    python3 docs/generate.py --pages FOLDER [PROGRAM]
                                        the pages of README.md, docs/lecture.md and docs/gallery/,
                                        into a folder, and their pictures, with a headless Chromium
                                        (docs/pictures.py)

In a template, a line `{{ARGUMENTS}}` is replaced by the output of `./run ARGUMENTS`. In a console
block, the output of `./run ARGUMENTS` follows the line `$ ./run ARGUMENTS`. A block that elides lines
by `...` is not changed: edit it by hand. The session blocks of a page run in one shell.
A marked part lies between `<!-- NAME: ... -->` and `<!-- end of NAME -->`.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent


def printed(arguments):
    """The output of the program. Exit code 1 is accepted: it means that the program found something."""
    result = subprocess.run(f"{ROOT}/run {arguments}", shell=True, cwd=ROOT, text=True, capture_output=True)
    if result.returncode not in (0, 1):
        sys.exit(f"./run {arguments}: {result.stderr}")
    return result.stdout


def worst_table():
    """The worst known inputs, from the first lines of tests/regressions/worst/."""
    rows = ["| method | worst known | file |", "|---|---|---|"]
    for path in sorted((ROOT / "tests/regressions/worst").glob("*.toml")):
        line = path.read_text().splitlines()[0]
        method, what = re.match(r"# (\S+) (.*)", line).groups()
        rows.append(f"| `{method}` | {what} | {path.name} |")
    return "\n".join(rows)


def from_template(name):
    template = (ROOT / "docs" / f"{name}.in.md").read_text()
    text = template.replace("{{worst-table}}", worst_table())
    written = ROOT / "docs" / f"{name}.md"
    with tempfile.TemporaryDirectory() as folder:
        def run(match):
            return printed(re.sub(r"(--view )(\S+)", rf"\1{folder}/\2", match[1])).strip()
        written.write_text(re.sub(r"^\{\{(.*)\}\}$", run, text, flags=re.MULTILINE))
        import pictures  # needs a browser, unlike most documents
        pictures.take([written], pathlib.Path(folder))


def shown(path):
    """Runs the commands of a file's console blocks again, and writes their output, unless a block elides lines."""
    def again(match):
        arguments, lines = match[1], match[2]
        if "\n...\n" in "\n" + lines:
            print(f"{path.name}: edit by hand: ./run {arguments}")
            return match[0]
        return f"```console\n$ ./run {arguments}\n{printed(arguments)}```"

    text = path.read_text()
    path.write_text(re.sub(r"```console\n\$ \./run (.*)\n((?:(?!```).*\n)*)```", again, text))


def laws_part(known):
    """The numbers of laws and sources, and the sentence of each law."""
    dials = [source for source in known["sources"] if source["dial"]]
    lines = [f"`properties` tries {len(known['laws'])} laws on random cases of "
             f"{len(known['sources'])} sources. {len(dials)} of these are stress",
             "sources, which have severities from 0 (ordinary) up. They make spheres far, rays grazing or tangent",
             "to the last bit, origins on the surface, and numbers at the ends of the double range.",
             "`--source distance@9` selects one severity. For a broken law, `properties` prints the smallest case",
             "found, as a scene that `check` accepts, and a string that replays it.", "", "| law | what must hold |", "|---|---|"]
    lines += [f"| `{law['name']}` | {law['sentence']} |" for law in known["laws"]]
    return "\n".join(lines)


def packages_part(when):
    """A table of the packages marked `when` in packages.txt."""
    lines = ["| package | licence | used for |", "|---|---|---|"]
    for line in (ROOT / "packages.txt").read_text().splitlines():
        if not line.startswith(when + " "):
            continue
        package, licence, sentence = (part.strip() for part in line[len(when):].split(" | "))
        lines.append(f"| {package.replace('|', ' or ')} | {licence} | {sentence} |")
    return "\n".join(lines)


def lists(program, check):
    """Writes the marked parts of pages again, or only checks whether that would change one."""
    listed = subprocess.run([program, "list", "--format", "json"], cwd=ROOT, text=True, check=True,
                            capture_output=True)
    pages = {"laws": {"laws": laws_part(json.loads(listed.stdout))},
             "packages": {"packages": packages_part("always"), "engines": packages_part("engines")}}
    for page, parts in pages.items():
        path = ROOT / "docs" / f"{page}.md"
        text = path.read_text()
        now = text
        for name, part in parts.items():
            marked = re.compile(rf"(<!-- {name}: .*-->\n).*?(<!-- end of {name} -->)", re.DOTALL)
            now, found = marked.subn(lambda match: f"{match[1]}{part}\n{match[2]}", now)
            if found != 1:
                sys.exit(f"{path.name}: expected one part marked {name}, found {found}")
        if check and now != text:
            sys.exit(f"{path.name} is stale: run python3 docs/generate.py --lists")
        if not check:
            path.write_text(now)


MARK = "\x01"


def sessions(path):
    """Runs the session blocks of a page, one after the other in one folder that is empty at first,
    and writes their output below their commands, unless lines are elided."""
    block = re.compile(r"```session\n((?:(?!```).*\n)*)```")
    commands = []  # for each block: pairs of a command's lines and its output lines
    for match in block.finditer(path.read_text()):
        commands.append([])
        for line in match[1].splitlines():
            if line.startswith("$ "):
                commands[-1].append(([line], []))
            elif line.startswith("> ") or line == ">":
                commands[-1][-1][0].append(line)
            else:
                commands[-1][-1][1].append(line)
    script = "exec 2>&1\n"
    for lines, _ in sum(commands, []):
        script += f"printf '{MARK}'\n" + "\n".join(line[2:] for line in lines) + "\n"
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, RAYCHECK=str(ROOT))
        environment["PATH"] = f"{ROOT}/build/release/tools:" + environment["PATH"]
        result = subprocess.run(["bash", "-c", script], cwd=folder, text=True, env=environment,
                                stdout=subprocess.PIPE)
    outputs = iter(result.stdout.split(MARK)[1:])
    texts = []
    for entries in commands:
        text = ""
        for lines, shown_lines in entries:
            now = next(outputs)
            kept = "\n".join(shown_lines) + "\n"
            text += "\n".join(lines) + "\n" + (kept if "..." in shown_lines else now)
        texts.append(f"```session\n{text}```")
    texts = iter(texts)
    path.write_text(block.sub(lambda match: next(texts), path.read_text()))


def run_raycheck(*arguments):
    return subprocess.run([ROOT / "build/release/tools/raycheck", *map(str, arguments)], stdout=subprocess.PIPE).stdout


def worst_input(asked, judged, family, quantity, searches):
    """The result of a search: the report of `worst`, its scene, and the certificate of its error, if there is one."""
    with tempfile.TemporaryDirectory() as folder:
        scene, certificates = pathlib.Path(folder, "found.toml"), pathlib.Path(folder, "found.jsonl")
        found = json.loads(run_raycheck("worst", *asked, "--source", family, "--quantity", quantity, "--by", "bound",
                                        "--searches", searches, "--save", scene, "--format", "json"))
        if not found["measured"] or not found["error"] or found["error"] == "infinity":
            return None
        # With --max-ulp 0 every error is a discrepancy, and so has a certificate.
        run_raycheck("check", scene, *judged, "--max-ulp", 0, "--top", 1000, "--certificates", certificates)
        place = {key: found["discrepancy"][key] for key in ("quantity", "pixel", "ray")}
        lines = [line for line in certificates.read_text().splitlines()
                 if place == {key: json.loads(line)[key] for key in place}]
        return found, tomllib.loads(scene.read_text()), lines[:1]


def worst_cases(searches):
    """Writes docs/worst-cases: the worst input found for each method and quantity, with certificates."""
    listed = json.loads(run_raycheck("list", "--format", "json"))
    single = ("--candidate", f"source:{ROOT}/tests/candidates/float_quadratic.cpp")
    intersect = [(method["name"], ("--method", f"intersect/{method['name']}"), ("--rays", "direct", "--intersect", method["name"]))
                 for method in listed["intersection_methods"]] + [("float_quadratic", single, single)]
    rays = [(method["name"], ("--method", f"rays/{method['name']}"), ("--rays", method["name"], "--intersect", "cross"))
            for method in listed["ray_methods"]]
    camera = "near left right bottom top width height".split()
    for name, methods, quantities, families, inputs in (
            ("intersect", intersect, ("parameter", "hit-point"), ("rays", "distance@6", "tangency@6"),
             "ox oy oz dx dy dz cx cy cz r".split()),
            ("rays", rays, ("direction", "pixel-point"), ("cameras", "far-camera@6", "up@6"),
             "ex ey ez ax ay az ux uy uz".split() + camera + ["i", "j"])):
        rows, certificates = [], []
        for method, asked, judged in methods:
            for quantity in quantities:
                for family in families:
                    worst = worst_input(asked, judged, family, quantity, searches)
                    if worst is None or not worst[2]:
                        continue
                    found, scene, certificate = worst
                    if name == "intersect":
                        ray, sphere = scene["ray"][0], scene["sphere"][0]
                        numbers = [*ray["origin"], *ray["direction"], *sphere["centre"], sphere["radius"]]
                    else:
                        its = scene["camera"]
                        numbers = [*its["eye"], *its["look_at"], *its["up"], *(its[key] for key in camera),
                                   *found["discrepancy"]["pixel"]]
                    rows.append([method, found["precision"], quantity, family, f"{found['error']:.6g}", found["unit"],
                                 str(found["condition"]), *(float(number).hex() for number in numbers),
                                 " ".join(found["discrepancy"]["exact"]),
                                 "; ".join(f"{key} = {value}" for key, value in scene.get("conventions", {}).items())])
                    certificates += certificate
        columns = "method precision quantity family error unit condition".split() + inputs + ["exact", "conventions"]
        folder = ROOT / "docs/worst-cases"
        (folder / f"{name}.csv").write_text("\n".join(",".join(row) for row in [columns, *rows]) + "\n")
        (folder / f"{name}.jsonl").write_text("\n".join(certificates) + "\n")


if __name__ == "__main__":
    if sys.argv[1:] == ["--performance"]:
        import performance
        performance.write()
    elif sys.argv[1:2] == ["--worst-cases"]:
        worst_cases(int((sys.argv[2:] + ["8"])[0]))
    elif sys.argv[1:2] == ["--lists"]:
        programs = [word for word in sys.argv[2:] if word != "--check"]
        lists(programs[0] if programs else "./run", "--check" in sys.argv[2:])
    elif sys.argv[1:2] == ["--pages"] and len(sys.argv) in (3, 4):
        import pictures  # needs a browser, unlike most documents
        pictures.make([ROOT / "README.md", ROOT / "docs/lecture.md", ROOT / "docs/gallery/README.md"],
                      *(sys.argv[2:] + ["./run"])[:2])
    elif sys.argv[1:] == ["--shown"]:
        for path in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]:
            shown(path)
        for name in ("campaigns", "grading", "students"):
            sessions(ROOT / "docs" / f"{name}.md")
    elif not sys.argv[1:]:
        from_template("error-against-run-time")
    else:
        sys.exit(__doc__)
