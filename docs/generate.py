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
import resource
import subprocess
import sys
import tempfile
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent


def printed(arguments):
    """The output of the program. Exit code 1 is accepted: it means that the program found something."""
    built = sorted(ROOT.glob("build/release/examples/engines/*.so"))
    engines = [f"--candidate library:{path.name}" for path in built]
    if engines:
        engines.append("--sandbox none --i-know")
    # In the engines' folder, so that their names are short.
    where = built[0].parent if built and "$ENGINES" in arguments else ROOT
    result = subprocess.run(f"{ROOT}/run {arguments}", shell=True, cwd=where, text=True,
                            capture_output=True, env={**os.environ, "ENGINES": " ".join(engines)})
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


def benchmarks(program, *options):
    """Rays per second and counters of a program's benchmarks, by name."""
    build = ["cmake", "--build", "--preset", "release", "--target", program]
    subprocess.run(build, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    command = [f"build/release/tools/bench/{program}", "--target=AVX2", "--benchmark_format=json",
               "--benchmark_min_time=0.2", *options]
    result = subprocess.run(command, cwd=ROOT, check=True, text=True, capture_output=True)
    rows = {}
    for row in json.loads(result.stdout)["benchmarks"]:
        if row.get("error_occurred"):
            sys.exit(f"{row['name']}: {row['error_message']}")
        if row.get("aggregate_name", "median") == "median":
            rows[row["name"].removesuffix("_median").removesuffix("/real_time")] = row
    return rows


def rate(row):
    return row["items_per_second"] / 1e6


def beside_embree(rows, scene):
    """Embree's time divided by raycheck's, and the share of its pixels that are wrong."""
    if f"{scene}/embree" not in rows:
        return "no floats"
    ours, embree = rows[f"{scene}/certified"], rows[f"{scene}/embree"]
    wrong = embree["wrong"] / (ours["items_per_second"] * ours["real_time"] / 1e9)
    return f"{rate(ours) / rate(embree):.2g}, {wrong:.2g}"


def spheres_table(rows):
    lines = ["| spheres | seen | certified, M/s | certified / uncertified | certified / Embree, Embree's wrong share "
             "| fallback pixels | wrong | plan + build, ms |", "|---|---|---|---|---|---|---|---|"]
    for name, ours in rows.items():
        if not (name.startswith("spheres:") and name.endswith("/certified")):
            continue
        scene = name.split("/")[0]
        lines.append(
            f"| {scene[8:]} | {ours['seen']:.0%} | {rate(ours):.0f} "
            f"| {rate(ours) / rate(rows[f'{scene}/uncertified']):.2f} | {beside_embree(rows, scene)} "
            f"| {ours['fallback']:.0f} | {ours['wrong']:.0f} | {ours['plan_ms']:.1f} + {ours['build_ms']:.1f} |")
    return "\n".join(lines)


def scenes_table(rows, kind):
    lines = ["| scene | spheres | seen | certified, M/s | certified / uncertified | certified / Embree, Embree's wrong share "
             "| fallback pixels | wrong |", "|---|---|---|---|---|---|---|---|"]
    for name, ours in rows.items():
        if not (name.startswith(kind + ":") and name.endswith("/certified")):
            continue
        scene = name.split("/")[0]
        lines.append(
            f"| {scene.split(':')[1]} | {ours['spheres']:.0f} | {ours['seen']:.0%} | {rate(ours):.3g} "
            f"| {rate(ours) / rate(rows[f'{scene}/uncertified']):.2g} | {beside_embree(rows, scene)} "
            f"| {ours['fallback']:.0f} | {ours['wrong']:.0f} |")
    return "\n".join(lines)


def families_of(rows, kind):
    """The severities of each stress family in order, each with its row."""
    families = {}
    for name, row in rows.items():
        if name.startswith("family:") and name.endswith("/" + kind):
            family, severity = name.split("/")[0][7:].split("@")
            families.setdefault(family, []).append((int(severity), row))
    return {family: sorted(found, key=lambda one: one[0]) for family, found in families.items()}


def plot_families(rows, path):
    """A panel for each family: throughput against severity, and the share of Embree's pixels that are wrong."""
    ours, embree = families_of(rows, "certified"), families_of(rows, "embree")
    script = [f"set terminal svg size 900,560 font 'sans,12' background 'white'; set output '{path}'",
              "set multiplot layout 2,3; set logscale y; set yrange [0.01:5000]; set ytics nomirror; set grid ytics",
              "set y2range [0:100]; set xlabel 'severity'"]
    for k, family in enumerate(ours):
        end = ours[family][-1][0]
        script += ["$certified << EOD"] + [f"{x} {rate(row)}" for x, row in ours[family]] + ["EOD"]
        script += ["$embree << EOD"] + [f"{x} {rate(row)} {row['wrong'] / 128 ** 2 * 100}"
                                        for x, row in embree[family]] + ["EOD"]
        script += [f"set title '{family}'; set xrange [{-0.02 * end}:{1.02 * end}]; "
                   f"set xtics {-(-end // 3)}",
                   "set ylabel 'M rays/s'; unset y2label" if k % 3 == 0 else "unset ylabel; unset y2label",
                   "set y2tics 25; set y2label 'wrong pixels, %'" if k % 3 == 2 else "unset y2tics",
                   "set key left bottom Left reverse samplen 2" if k == 1 else "unset key",
                   "plot $certified with linespoints pointtype 7 linecolor '#0072b2' title 'certified', "
                   "$embree with linespoints pointtype 5 linecolor '#d55e00' title 'Embree', "
                   "$embree using 1:3 axes x1y2 with lines dashtype 2 linecolor '#777777' title 'wrong, %'"]
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)


def families_table(rows):
    """Certified images of each stress family, by severity: M/s, and the pixels that fall back."""
    lines = ["| source | M/s at severity 0 | M/s at other severities | smallest rate / rate at severity 0 "
             "| largest share of fallback pixels |",
             "|---|---|---|---|---|"]
    for family, found in families_of(rows, "certified").items():
        first, others = found[0][1], found[1:]
        if min(rate(row) for _, row in found) < rate(first) / 10:
            sys.exit(f"{family}: the rate at a severity is below a tenth of the rate at 0, contrary to docs/performance.in.md")
        lines.append(f"| {family} | {rate(first):.3g} | "
                     + ", ".join(f"@{severity}: {rate(row):.3g}" for severity, row in others)
                     + f" | {min(rate(row) for _, row in found) / rate(first):.2g} "
                     f"| {max(row['fallback'] for _, row in found) / 128 ** 2:.0%} |")
    return "\n".join(lines)


def methods_table(rows):
    """The batches of one sphere, ordered by their time divided by that of the textbook's formula."""
    textbook = rate(rows["intersect/quadratic"])
    lines = ["| method | M/s | time / time of `quadratic` |", "|---|---|---|"]
    for name, row in sorted(rows.items(), key=lambda item: -rate(item[1])):
        lines.append(f"| {name.split('/')[1]} | {rate(row):.3g} | {textbook / rate(row):.3g} |")
    return "\n".join(lines)


def plot_spheres(rows, path):
    """A plot with a curve for certified and one for uncertified images."""
    kinds = {"certified": "pointtype 7 linecolor '#0072b2'", "uncertified": "pointtype 5 linecolor '#d55e00'"}
    script = [f"set terminal svg size 720,440 font 'sans,13' background 'white'; set output '{path}'",
              "set logscale xy; set xlabel 'spheres'; set ylabel 'M rays/s'; set grid"]
    for kind in kinds:
        points = [(name.split("/")[0][8:], rate(row)) for name, row in rows.items()
                  if name.startswith("spheres:") and name.endswith("/" + kind)]
        script += [f"${kind} << EOD"] + [f"{x} {y}" for x, y in points] + ["EOD"]
    script.append("plot " + ", ".join(f"${kind} with linespoints {look} title '{kind}'" for kind, look in kinds.items()))
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)


def campaign(*options):
    """The number of judged cases, the CPU time and the elapsed time of a campaign of the default pair."""
    command = [str(ROOT / "build/release/tools/raycheck"), "properties", "--rays", "direct", "--intersect", "cross",
               "--format", "json", *options]
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    passed, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    report = json.loads(result.stdout) if result.stdout else {"campaigns": []}
    judged = sum(one["cases"] for one in report["campaigns"])
    return judged, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, passed


def laws_table():
    """Cases judged per second of CPU, for all laws together and for each law by itself."""
    listed = subprocess.run([ROOT / "build/release/tools/raycheck", "list", "--format", "json"], stdout=subprocess.PIPE)
    laws = [law["name"] for law in json.loads(listed.stdout)["laws"]]
    rates = []
    for law in laws:
        if sum(law in other for other in laws) > 1 or law == "image":
            continue  # --filter would match other laws, too; no method draws
        judged, cpu, _ = campaign("--filter", law, "--cases", "4000", "--threads", "1")
        rates.append((judged / cpu, law))
    lines = ["| law | judged per second |", "|---|---|"]
    for level in ("ordinary", "demanding", "extreme"):
        judged, cpu, _ = campaign("--cases", "4000", "--threads", "1", "--level", level)
        lines.append(f"| all in one pass, {level} | {judged / cpu:,.0f} |")
    return "\n".join(lines + [f"| only {law} | {rate:,.0f} |" for rate, law in sorted(rates, reverse=True)])


def growth_table():
    """One campaign with more workers: elapsed time and total CPU time, divided by those with one worker."""
    case = ("--cases", "100000")
    _, cpu, passed = campaign(*case, "--threads", "1")
    lines = ["| workers | speed-up | CPU time / that of 1 thread |", "|---|---|---|", "| 1 thread | 1 | 1 |"]
    _, more, less = campaign(*case, "--threads", "2")
    lines.append(f"| 2 threads | {passed / less:.2f} | {more / cpu:.2f} |")
    for count in (2, 64):
        with tempfile.TemporaryDirectory() as folder:
            before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
            command = [str(ROOT / "build/release/tools/raycheck"), "properties", "--rays", "direct", "--intersect", "cross",
                       *case, "--threads", "1", "--out", folder]
            waiting = [command + ["--shard", f"{k}/{count}"] for k in range(1, count + 1)]
            running = []
            while waiting or running:  # two at a time
                while waiting and len(running) < 2:
                    running.append(subprocess.Popen(waiting.pop(0), stderr=subprocess.DEVNULL))
                running.pop(0).wait()
            subprocess.run([command[0], "merge", folder], stdout=subprocess.DEVNULL)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            more = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            lines.append(f"| {count} shards, two at a time, and merge | {passed / (time.monotonic() - start):.2f} | "
                         f"{more / cpu:.2f} |")
    return "\n".join(lines)


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


def performance():
    rows = benchmarks("bench_visibility")
    if "spheres:1/embree" not in rows:
        sys.exit("bench_visibility was built without Embree: Debian's libembree-dev")
    methods = benchmarks("bench_kernels", "--benchmark_filter=intersect/", "--benchmark_repetitions=5",
                         "--benchmark_report_aggregates_only=true")
    plot_spheres(rows, ROOT / "docs/images/visibility.svg")
    plot_families(rows, ROOT / "docs/images/families.svg")
    parts = {"spheres": spheres_table(rows), "shipped": scenes_table(rows, "shipped"),
             "hard": scenes_table(rows, "hard"), "families": families_table(rows),
             "methods": methods_table(methods), "laws": laws_table(), "growth": growth_table()}
    text = (ROOT / "docs/performance.in.md").read_text()
    for name, part in parts.items():
        text = text.replace("{{" + name + "}}", part)
    (ROOT / "docs/performance.md").write_text(text)


if __name__ == "__main__":
    if sys.argv[1:] == ["--performance"]:
        performance()
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
