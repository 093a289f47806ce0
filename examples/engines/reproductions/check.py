#!/usr/bin/env python3
"""Runs reproductions on three rays: ./check.py [DIR [NAME...]]. DIR, here if it is not said, has the node_modules."""
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
RAYS = {"ahead": "0 0 -5 0 0 1 0 0 0 1", "beside": "0 3 -5 0 0 1 0 0 0 1", "inside": "0 0 0.5 0 0 1 0 0 0 1"}
RIGHT = {"ahead": [["hit"], [4.0], [0.0, 0.0, -1.0]], "beside": [["miss"]],
         "inside": [["hit"], ["miss"], [0.5], [-1.5], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 2.0]]}  # by contract; 2: PlayCanvas


def answer(template, ray, folder):
    text = template.read_text()
    for name, value in zip("ox oy oz dx dy dz cx cy cz r".split(), ray.split()):
        text = text.replace("{" + name + "}", repr(float(value)))
    (folder / f"case{template.suffix}").write_text(text)
    command = re.match(r"(?://|#) ([^,\n]*)", text)[1]
    command += " && ./case" if template.suffix in (".c", ".cpp") else ""
    run = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True)
    words = run.stdout.split() or [run.stderr[-200:]]
    return words if words[0] in ("hit", "miss") or run.returncode else [round(float(x), 6) + 0.0 for x in words]


folder, *names = sys.argv[1:] or ["."]
wrong = 0
with tempfile.TemporaryDirectory(dir=folder) as place:
    (pathlib.Path(place) / "node_modules").symlink_to(pathlib.Path(folder, "node_modules").resolve())
    for template in sorted(HERE.glob("[a-z]*.*")):
        if template.name != "check.py" and (not names or template.stem in names):
            found = {ray: answer(template, numbers, pathlib.Path(place)) for ray, numbers in RAYS.items()}
            fails = {ray: words for ray, words in found.items() if words not in RIGHT[ray]}
            wrong += bool(fails)
            print(template.name, fails or "as expected", flush=True)
sys.exit(wrong > 0)
