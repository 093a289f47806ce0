"""Shared by the tests of pages: the program, the pages that it makes, and one browser for all tests of a file.

A file of tests is run as `python3 FILE PROGRAM [unittest's arguments]`. It exits with 0, with 1 if a test failed, and
with 77 if a test was skipped; then it prints the reason. Tests assert times only with RAYCHECK_BROWSER_TIMES=1.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import webdriver

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXAMPLES = sorted((ROOT / "scene/examples").iterdir())
NPM = ROOT / "build/npm/node_modules"  # made by `./run packages ci`
MOST_SECONDS = 3  # the longest time in which a page must open
SKIPPED = 77  # ctest's exit code for a skipped test

# When the page is ready and drawn, resolves to the milliseconds since it was requested.
READY = """return window.raycheckPage.ready.then(() => new Promise((done) =>
  requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now())))));"""


class Shared:
    program = ROOT / "build/release/tools/raycheck"
    folder = None
    browser = None
    browser_arguments = ()
    pages = {}


def ran(*arguments):
    """The output of a run of the program; it exits with 1 if it found something, with 4 if there was nothing to judge."""
    result = subprocess.run([str(Shared.program), *map(str, arguments)], cwd=ROOT, text=True, capture_output=True)
    if result.returncode not in (0, 1, 4):
        raise RuntimeError(f"raycheck {' '.join(map(str, arguments))}: {result.stderr}")
    return result.stdout


def temporary(name, text=None):
    """A path in the folder of this run. If there is a text, it is written to the file."""
    path = Shared.folder / name
    if text is not None:
        path.write_text(text)
    return path


def candidate(file, intersect, name="-"):
    """Writes a Python candidate that begins with these lines of code, and returns its path."""
    return temporary(file, f"""import sys
sys.path.insert(0, {str(ROOT / "tools/external/adapters")!r})
import raycheck_candidate as rc
{intersect}
rc.run({name!r}, intersect=intersect)
""")


def page_of(*arguments, option="--out"):
    """The page that `raycheck view ARGUMENTS` writes, or with `option` another command; cached by its arguments."""
    if arguments not in Shared.pages:
        path = temporary(f"{len(Shared.pages)}.html")
        ran(*(("view",) if option == "--out" else ()), *arguments, option, path)
        Shared.pages[arguments] = path
    return Shared.pages[arguments]


class PageTest(unittest.TestCase):
    """Every page that a test opens makes no requests, and leaves the console empty."""

    page_open = None
    expected_problems = 0

    @classmethod
    def setUpClass(cls):
        if Shared.browser is None:
            if reason := webdriver.missing():
                raise unittest.SkipTest(reason)
            Shared.browser = webdriver.Browser(*Shared.browser_arguments)
        cls.browser = Shared.browser

    @classmethod
    def open(cls, path, fragment=""):
        """Opens a page, at a fragment of its address, and returns how many seconds it took until all of it was drawn."""
        cls.check_page()
        cls.browser.open(f"{path}{fragment}")
        cls.page_open = path
        seconds = cls.browser.run(READY) / 1000
        if os.environ.get("RAYCHECK_BROWSER_TIMES") == "1" and seconds > MOST_SECONDS:
            raise AssertionError(f"{path}: open after {seconds} s")
        return seconds

    def run_script(self, script, *arguments):
        return self.browser.run(script, *arguments)

    def text(self, selector):
        return self.run_script("return document.querySelector(arguments[0]).textContent", selector)

    def selection(self):
        return self.run_script("return raycheckPage.store.selection")

    @classmethod
    def check_page(cls):
        page, cls.page_open = cls.page_open, None
        if page is None:
            return
        problems = cls.browser.problems()
        if len(problems) != cls.expected_problems:
            raise AssertionError(f"the console shows {problems}")
        asked = cls.browser.requests()
        if asked != [f"file://{page}"]:
            raise AssertionError(f"{page} asked for {asked}")

    def tearDown(self):
        self.check_page()


def said(text):
    """Prints a line to the test's output."""
    print(text, file=sys.stderr, flush=True)


def main(*browser_arguments):
    Shared.browser_arguments = browser_arguments
    Shared.program = pathlib.Path(sys.argv.pop(1)).resolve()
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="raycheck-browser-") as folder:
        Shared.folder = pathlib.Path(folder)
        try:
            result = unittest.main(module="__main__", exit=False, verbosity=1).result
        finally:
            if Shared.browser is not None:
                Shared.browser.close()
    said(f"{time.monotonic() - start:.1f} s")
    for _, reason in result.skipped:
        said(f"skipped: {reason}")
    sys.exit(1 if not result.wasSuccessful() else SKIPPED if result.skipped else 0)
