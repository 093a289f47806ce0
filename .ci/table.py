"""Prints the time of each stage, and the stages over budget: python3 table.py STAGES BUDGET SUITES.

STAGES has lines NAME WALL USER SYSTEM in seconds, SUITES lines PROGRAM PROCESSOR (the file may be missing). BUDGET has lines
NAME RATIO: processor time divided by that of the stage `reference` in the same run on the same machine.
Stages over budget are listed last, but do not fail, since times depend on load.
"""

import os
import sys


def lines_of(path):
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return [line.split() for line in file if line.strip() and not line.startswith("#")]


def main():
    stages = [(name, float(wall), float(user) + float(system)) for name, wall, user, system in lines_of(sys.argv[1])]
    stages.append(("all", sum(wall for _, wall, _ in stages), sum(processor for _, _, processor in stages)))
    suites = [(name, float(processor)) for name, processor in lines_of(sys.argv[3])]
    budget = {name: float(ratio) for name, ratio in lines_of(sys.argv[2])}
    unit = next((processor for name, _, processor in stages if name == "reference"), None)
    over = []
    print(f"{'stage':24} {'clock, s':>9} {'processors, s':>14} {'/ reference':>12} {'budget':>7}")
    rows = [(name, f"{wall:9.0f}", processor) for name, wall, processor in stages]
    rows += [(name, " " * 9, processor) for name, processor in sorted(suites, key=lambda suite: -suite[1])]
    for name, wall, processor in rows:
        allowed = budget.get(name)
        ratio = processor / unit if unit else None
        print(f"{name:24} {wall} {processor:14.1f} {'-' if ratio is None else format(ratio, '.2f'):>12} "
              f"{'-' if allowed is None else format(allowed, '.2f'):>7}")
        if ratio is not None and allowed is not None and ratio > allowed:
            over.append(f"{name} {ratio:.2f} of {allowed:.2f}")
        elif unit and allowed is None and ratio > 0.5:
            over.append(f"{name} {ratio:.2f}, which has no budget")
    print("over budget: " + ("; ".join(over) if over else "nothing"))


main()
