"""Passes on ctest's output; inserts before its summary the slowest tests and the skipped ones.

usage: ctest ... | python3 tests/summary.py LOG [TABLE], where LOG is ctest's own log, Testing/Temporary/LastTest.log. TABLE
gets a line for each test program: its name and the processor seconds that its suites took.
"""

import collections
import re
import sys

MOST = 10
BEGINS = re.compile(r"\d+/\d+ Testing: (.*)$")
COMMAND = re.compile(r'Command: "(.*)"$')
PROCESSOR = re.compile(r"processor time: ([0-9.]+) \+ ([0-9.]+) s$")
WALL = re.compile(r"Test time = +([0-9.]+) sec$")
SKIPPED = re.compile(r"\[  SKIPPED \] (\d+) tests?, listed below:$")


def program_of(command):
    """The program that a test runs: the first word of its command that is not an interpreter."""
    words = [word for word in command.split('" "') if not word.endswith(("bash", "timed.sh", "python3"))]
    return words[0].rsplit("/", 1)[-1]


def read(path):
    """For every test in ctest's log: its name, program, processor and wall seconds, and its number of skipped tests."""
    tests = []
    with open(path, encoding="utf-8", errors="replace") as log:
        for line in log:
            if found := BEGINS.match(line):
                tests.append({"name": found[1], "program": "", "processor": 0.0, "wall": 0.0, "skipped": 0})
            elif not tests:
                continue
            elif found := COMMAND.match(line):
                tests[-1]["program"] = program_of(found[1])
            elif found := PROCESSOR.match(line):
                tests[-1]["processor"] = float(found[1]) + float(found[2])
            elif found := WALL.match(line):
                tests[-1]["wall"] = float(found[1])
            elif found := SKIPPED.match(line):
                tests[-1]["skipped"] = int(found[1])
    return tests


def main():
    log, table = sys.argv[1], sys.argv[2:]
    closing = []  # ctest's own log is complete once it has ended
    for line in sys.stdin:
        if closing or "tests passed, " in line:
            closing.append(line)
        else:
            print(line, end="", flush=True)
    tests = read(log) if closing else []
    if tests:
        print(f"The most processor time of {len(tests)} suites, of {sum(test['processor'] for test in tests):.0f} s in all:")
    for test in sorted(tests, key=lambda test: -test["processor"])[:MOST]:
        print(f"{test['processor']:8.1f} s ({test['wall']:.1f} s on the clock)  {test['name']}")
    for test in tests:
        if test["skipped"]:
            print(f"{test['skipped']} skipped of {test['name']}")
    print()
    print("".join(closing), end="")
    if table:
        programs = collections.Counter()
        for test in tests:
            programs[test["program"]] += test["processor"]
        with open(table[0], "w", encoding="utf-8") as file:
            file.writelines(f"{name} {seconds:.2f}\n" for name, seconds in sorted(programs.items()))


main()
