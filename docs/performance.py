"""Measures, and writes docs/performance.md and its plots (docs/generate.py --performance)."""
import json
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


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


def arrays_table():
    """What bench_batch prints, each row beside what it is measured against."""
    subprocess.run(["cmake", "--build", "--preset", "release", "--target", "bench_batch"], cwd=ROOT, check=True,
                   stdout=subprocess.DEVNULL)
    printed = subprocess.run(["build/release/tools/bench/bench_batch", "--target=AVX2"], cwd=ROOT, check=True, text=True,
                             capture_output=True).stdout
    rows = re.findall(r"^(.+?) +([\d.]+) ns +([\d.]+) M/s +([\d.]+) times the speed of (.+)$", printed, re.M)
    lines = ["| function | ns a ray | M/s | its speed / that of | |", "|---|---|---|---|---|"]
    return "\n".join(lines + [f"| {name} | {time} | {rate} | {ratio} | {other} |" for name, time, rate, ratio, other in rows])


def beside_python():
    """NumPy arrays beside other ways in Python (docs/arrays.py), by the Python for which the module was built."""
    return subprocess.run([ROOT / "docs/arrays.py"], check=True, text=True, capture_output=True).stdout.rstrip()


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


def write():
    if not shutil.which("gnuplot"):
        sys.exit("gnuplot is needed for the plots: Debian's gnuplot-nox")
    rows = benchmarks("bench_visibility")
    if "spheres:1/embree" not in rows:
        sys.exit("bench_visibility was built without Embree: Debian's libembree-dev")
    methods = benchmarks("bench_kernels", "--benchmark_filter=intersect/", "--benchmark_repetitions=5",
                         "--benchmark_report_aggregates_only=true")
    plot_spheres(rows, ROOT / "docs/images/visibility.svg")
    plot_families(rows, ROOT / "docs/images/families.svg")
    parts = {"spheres": spheres_table(rows), "shipped": scenes_table(rows, "shipped"),
             "hard": scenes_table(rows, "hard"), "families": families_table(rows),
             "methods": methods_table(methods), "arrays": arrays_table(),
             "python": beside_python(), "laws": laws_table(), "growth": growth_table()}
    text = (ROOT / "docs/performance.in.md").read_text()
    for name, part in parts.items():
        text = text.replace("{{" + name + "}}", part)
    (ROOT / "docs/performance.md").write_text(text)
