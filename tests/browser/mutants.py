#!/usr/bin/env python3
"""Tests the tests of pages: python3 tests/browser/mutants.py PROGRAM [NAME ...] fails if a test passes on a broken page.

Run by hand, as it takes minutes. The tests are given this file instead of the program: it runs the program and then breaks
the written page in one place, and updates the policy's hashes.
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parent
# For each mutant: the test that must fail, the text of the page that is replaced, and its
# replacement.
MUTANTS = {
    "error in the console": ("examples", "await runThree();", 'await runThree(); console.error("x");'),
    "a request": ("examples", "await runThree();", 'await runThree(); new Image().src = "http://127.0.0.1:9/";'),
    "never ready": ("examples", "await runThree();", 'throw new Error("x");'),
    "no canvas": ("examples", "figure.canvas.hidden = isFlat", "figure.canvas.hidden = true"),
    "always along -W": ("eye", "times(W, Math.sign(near))", "times(W, -1)"),
    "half a pixel off": ("eye", "...wide(x0, x1, enlarged", "...wide(x0 + (x1 - x0) / 160, x1, enlarged"),
    "from the eye, always": ("eye", 'origin === "pixel" ? depth : 0', "0"),
    "no interval": ("eye", "const counted = [from / unit, Math.min((to ?? Infinity) / unit, 3e38)]", "const counted = [0, 3e38]"),
    "no culling": ("eye", "inRadii, smaller, larger]", "inRadii, true, true]"),
    "farthest first": ("eye", "(b.distance - b.radius) - (a.distance - a.radius)", "(a.distance - a.radius) - (b.distance - b.radius)"),
    "silent about what is too far": ("eye", "farthest > GREATEST_DEPTH ? ", "false ? "),
    "text with a space more": ("explain", 'tabindex: "0" }, text)', 'tabindex: "0" }, text + " ")'),
    "another command": ("explain", '"Copy as command", command', '"Copy as command", command + " --format json"'),
    "another scene": ("explain", "takeAway(told, store.scene().toml)", "takeAway(told, store.document.title)"),
    "the scene for the command": ("explain", '"Copy as command", command)', '"Copy as command", toml)'),
    "picture upside down": ("use", "pictureRow(row, camera)] } }", "row] } }"),
    "arrow keys upside down": ("use", 'camera.rows === "top-first" ? -up : up', "up"),
    "figure's clicks mirrored": ("use", "x0 + (x / width) * (x1 - x0)", "x1 + (x / width) * (x0 - x1)"),
    "findings without a place": ("use", "selection: { pixel, ray, sphere } }", "selection: { pixel: [0, 0], ray, sphere } }"),
    "addresses without a finding": ("use", "  follow();\n", "\n"),
    "the next finding": ("use", "findings[Number(number) - 1]", "findings[Number(number)]"),
    "starts anywhere": ("use", "selection: { ...document.scenes[first].start }", "selection: { pixel: [0, 0], ray: null, sphere: 0 }"),
    "every method always": ("use", "store.methodShown === null || name === store.methodShown", "true"),
    "divider does not move": ("use", "inset(0 0 0 ${percent}%)", "inset(0 0 0 50%)"),
    "figure does not turn": ("use", "    update();", ""),
    "the wheel takes all": ("use", "event.stopImmediatePropagation()", "[]"),
    "left is right": ("use", "shown.sides[side] = Number(value)", "shown.sides.left = Number(value)"),
    "dial stays": ("use", "store.set({ scenesIndex: dial.scenes[k] })", "store.set({ scenesIndex: dial.scenes[0] })"),
    "microscope mirrored": ("use", "width / 2 + ulps / half * width / 2", "width / 2 - ulps / half * width / 2"),
    "window does not widen": ("use", "shown.zoom = k;", "shown.zoom = 0;"),
    "WebGL or nothing": ("use", "if (!context) return null;", 'if (!context) throw new Error("x");'),
    "text as HTML": ("hostile", "node.append(...children", 'node.insertAdjacentHTML("beforeend", children.flat(Infinity).filter((one) => typeof one === "string").join("")); node.append(...children'),
    "names are not escaped": ("hostile", "&lt;", "<"),
    "no policy": ("hostile", 'http-equiv="Content-Security-Policy"', 'name="x"'),
    "silent about what is left out": ("large", "...read.left_out.map(", "...[].map("),
    "no way to ask": ("large", "--pixel ${pixel.join()}", ""),
    "pale words": ("access", "--quiet: #565d66", "--quiet: #b5bdc6"),
    "pale words in the dark": ("access", "--quiet: #a5adb6", "--quiet: #454d56"),
    "a field without a name": ("access", 'element("label", { for: id, class: "field" }, element("span", {}, label), fields)', 'element("div", {}, fields)'),
    "wider than the window": ("access", "margin: 0 auto; max-width: 1800px;", "margin: 0 auto; min-width: 1500px;"),
}


def sha256(text):
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def broken(page, old, new):
    """The page with the text replaced, if it has it; the policy allows the change."""
    changed = page.replace(old, new)
    for pattern in (r"<script>(.*?)</script>\n</body>", r"<style>(.*?)</style>"):
        before, after = (re.search(pattern, text, re.DOTALL)[1] for text in (page, changed))
        changed = changed.replace(sha256(before), sha256(after))
    return changed


def run_as_program(name, arguments):
    done = subprocess.run([os.environ["RAYCHECK_UNBROKEN"], *arguments])
    if arguments[0] == "view" and "--out" in arguments:
        page = pathlib.Path(arguments[arguments.index("--out") + 1])
        page.write_text(broken(page.read_text(), *MUTANTS[name][1:]))
    sys.exit(done.returncode)


def main(program, *names):
    alive = []
    for name in names or MUTANTS:
        result = subprocess.run([sys.executable, TESTS / f"{MUTANTS[name][0]}_test.py", __file__, "--failfast"], text=True, capture_output=True,
                                env={**os.environ, "RAYCHECK_UNBROKEN": str(pathlib.Path(program).resolve()), "RAYCHECK_MUTANT": name})
        reasons = [line for line in result.stderr.splitlines() if re.match(r"\w*(Error|Exception)\b", line)]
        print(f"{'ALIVE' if result.returncode == 0 else 'caught'}  {name}: {reasons[0][:150] if reasons else result.returncode}", flush=True)
        if result.returncode == 0 or not reasons:
            alive.append(name)
    sys.exit(f"not caught: {alive}" if alive else 0)


if __name__ == "__main__":
    if "RAYCHECK_MUTANT" in os.environ:
        run_as_program(os.environ["RAYCHECK_MUTANT"], sys.argv[1:])
    main(*sys.argv[1:])
