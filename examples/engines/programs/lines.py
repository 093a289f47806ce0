"""A program in any language that answers line by line: python3 lines.py FILE. The first line of FILE is a comment with the
command that runs it; {} stands for its path. It reads lines of ten numbers: the origin and the direction of a ray, the centre
and the radius of a sphere. It answers each with a line: "= miss", "= hit", or "= " and the numbers of its answer; other lines
are ignored. Comment lines `raycheck WORD VALUE...` are its declarations, with the keywords of raycheck_candidate.run.
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys

import raycheck_candidate as rc


def main(file):
    source = pathlib.Path(file).read_text()
    command = re.sub(r"^\W*|\W*$", "", source.splitlines()[0].replace("{}", shlex.quote(file)))
    program = subprocess.Popen(["sh", "-c", command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                               env=os.environ | {"HOME": os.getcwd()})

    def intersect(ray, sphere, _):
        # One line at a time: Octave would wait for the line after the last of several.
        print(*map(float, (*ray[0], *ray[1], *sphere[0], sphere[1])), file=program.stdin, flush=True)
        words = next((line[2:].split() for line in program.stdout if line.startswith("= ")), None)
        if words is None:
            raise RuntimeError(f"the program ended: {command}")
        if words in (["miss"], ["hit"]):
            return words == ["hit"]
        values = tuple(map(float, words))
        return values if len(values) > 1 else values[0]

    declared = dict(re.findall(r"^\W+raycheck (\S+) (.*)$", source, re.MULTILINE))
    rc.run(pathlib.Path(file).stem, intersect=intersect, **declared)


main(sys.argv[1])
