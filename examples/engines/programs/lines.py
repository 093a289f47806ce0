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

    def answer():
        words = next((line[2:].split() for line in program.stdout if line.startswith("= ")), None)
        if words is None:
            raise RuntimeError(f"the program ended: {command}")
        if words in (["miss"], ["hit"]):
            return words == ["hit"]
        values = tuple(map(float, words))
        return values if len(values) > 1 else values[0]

    def intersect_batch(rays, sphere, _):
        answers = []
        for k in range(0, len(rays), 200):  # few enough for all answers to fit in the pipe
            questions = [(*origin, *direction, *sphere[0], sphere[1]) for origin, direction in rays[k:k + 200]]
            program.stdin.writelines(" ".join(map(repr, map(float, question))) + "\n" for question in questions)
            program.stdin.flush()
            answers += [answer() for _ in questions]
        return answers

    declared = dict(re.findall(r"^\W+raycheck (\S+) (.*)$", source, re.MULTILINE))
    rc.run(pathlib.Path(file).stem, intersect_batch=intersect_batch, **declared)


main(sys.argv[1])
