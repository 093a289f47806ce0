"""Passes on what ctest prints; before its summary, which tests took longest."""

import re
import sys

MOST = 10
FINISHED = re.compile(r" *\d+/\d+ +Test +#\d+: (.*?) \.*.* ([0-9.]+) sec$")

took = []
for line in sys.stdin:
    if finished := FINISHED.match(line):
        took.append((float(finished[2]), finished[1]))
    if "tests passed, " in line and took:
        print(f"The slowest of {len(took)} tests:")
        for seconds, name in sorted(took, reverse=True)[:MOST]:
            print(f"{seconds:8.1f} s  {name}")
        print()
    print(line, end="", flush=True)
