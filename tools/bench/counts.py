#!/usr/bin/env python3
"""Counts the instructions of each kernel of bench_kernels under callgrind, and compares them with a
committed baseline: counts repeat where times do not.

  counts.py PROGRAM BASELINE            fails beyond 5% more
  counts.py PROGRAM BASELINE --accept   writes a new baseline

Exit code: 0 as before, 1 more instructions or wrong answers, 77 skipped, and why.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

MOST_MORE = 0.05
SKIPPED = 77
ACCEPT = "./run bench --counts --accept"
# Uses the C library's plainest variants for the processor, and nothing from the user's environment.
ENVIRONMENT = {
    "PATH": os.environ.get("PATH", ""),
    "LC_ALL": "C",
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-AVX,-FMA,-FMA4,-BMI2,-ERMS,-FSRM,-SSE4_2,-SSE4_1",
}


def skip(reason):
    print("SKIPPED: " + reason)
    sys.exit(SKIPPED)


def checked(program):
    """Runs the program's check of its answers; returns its compiler and build type."""
    run = subprocess.run([program, "--check"], env=ENVIRONMENT, text=True, capture_output=True)
    if run.returncode != 0:
        sys.exit("bench_kernels: " + run.stderr.strip())
    return run.stdout.strip()


def counted(program):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--collect-atstart=no",
             f"--callgrind-out-file={out}", program, "--count"],
            env=ENVIRONMENT, text=True, capture_output=True)
        if run.returncode != 0:
            sys.exit(run.stderr)
        counts = {}
        for part in pathlib.Path(folder).iterdir():
            text = part.read_text()
            name = re.search(r"^desc: Trigger: Client Request: (.*)$", text, re.M)
            if name:
                counts[name[1]] = int(re.search(r"^(?:totals|summary): (\d+)", text, re.M)[1])
    return counts


def compared(before, now):
    """Prints a line for each kernel; returns messages about changed counts."""
    wrong = []
    for name in sorted(before.keys() | now.keys()):
        if name not in now:
            wrong.append(f"{name}: in the baseline, but the kernel no longer exists")
        elif name not in before:
            wrong.append(f"{name}: {now[name]:,} instructions, but not in the baseline")
        else:
            more = now[name] / before[name] - 1
            print(f"{name:32}{before[name]:>14,}{now[name]:>14,}{more:>+9.2%}")
            if more > MOST_MORE:
                wrong.append(f"{name}: {now[name]:,} instructions, {more:.1%} more than the "
                             f"baseline's {before[name]:,}; at most {MOST_MORE:.0%} are allowed")
    return wrong


def main():
    program, baseline = sys.argv[1:3]
    accept = sys.argv[3:] == ["--accept"]
    if shutil.which("valgrind") is None:
        skip("valgrind is not installed")
    if " avx2 " not in pathlib.Path("/proc/cpuinfo").read_text():
        skip("this processor has no AVX2, for which the kernels are counted")
    built_by = checked(program)
    committed = json.loads(pathlib.Path(baseline).read_text()) if os.path.exists(baseline) else {}
    if not built_by.startswith(("g++", "clang++")):
        skip(built_by)
    if not accept and committed.get("built_by") != built_by:
        skip(f"the baseline is of {committed.get('built_by')}; this is {built_by}")
    now = counted(program)
    if accept:
        text = json.dumps({"built_by": built_by, "instructions": now}, indent=2, sort_keys=True)
        pathlib.Path(baseline).write_text(text + "\n")
        print(f"{len(now)} kernels: accepted as {baseline}")
        return
    wrong = compared(committed["instructions"], now)
    if wrong:
        print("\n" + "\n".join(wrong))
        print(f"If that is meant, accept a new baseline: {ACCEPT}")
        sys.exit(1)


main()
