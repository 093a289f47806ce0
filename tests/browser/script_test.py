"""The page's JavaScript: its size, and the messages of ESLint, which runs in the browser."""
import json
import re
import unittest

import pages
from pages import NPM, PageTest, ROOT, page_of, temporary

MODULES = sorted((ROOT / "tools/view/page").glob("*.js"))
MOST_LINES = 1500  # of code, in all
MOST_COLUMNS = 120
ESLINT = NPM / "eslint-linter-browserify/linter.min.js"
BROKEN = "let a = 1;\nvar b = a;\nif (b == undeclared) document.body.innerHTML = b;\n"


def lines_of_code(module):
    """All lines except empty ones and comments."""
    return [line for line in module.read_text().splitlines() if line.strip() and not line.lstrip().startswith("//")]


class Size(unittest.TestCase):
    def test_it_is_small(self):
        lines = {module.name: len(lines_of_code(module)) for module in MODULES}
        self.assertGreater(len(lines), 5)
        self.assertLessEqual(sum(lines.values()), MOST_LINES, lines)
        for module in MODULES:
            self.assertLessEqual(max(map(len, module.read_text().splitlines())), MOST_COLUMNS, module.name)


@unittest.skipUnless(ESLINT.exists(), "there is no ESLint here: ./run packages ci")
class Lint(PageTest):
    def complaints(self, text, source_type):
        config = json.loads((ROOT / "tests/browser/lint.json").read_text())
        config["languageOptions"]["sourceType"] = source_type
        found = self.run_script(f"{ESLINT.read_text()};\nreturn new eslint.Linter().verify(arguments[0], arguments[1]);", text, config)
        return [f"{one['line']}:{one['column']} {one['ruleId']}: {one['message']}" for one in found]

    def setUp(self):
        self.browser.open(temporary("blank.html", "<!doctype html><title>blank</title>"))

    def test_broken_code_is_found(self):
        found = " ".join(self.complaints(BROKEN, "module"))
        for rule in ("prefer-const", "no-var", "eqeqeq", "no-undef", "no-restricted-syntax"):
            self.assertIn(rule, found)

    def test_every_module(self):
        for module in MODULES:
            with self.subTest(module.name):
                self.assertEqual(self.complaints(module.read_text(), "module"), [])

    def test_the_modules_together(self):
        """The bundled script, as in a page: no name is missing or unused."""
        page = page_of(ROOT / "scene/examples/first-camera.toml").read_text()
        script = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)[-1]
        self.assertGreater(len(script), 10_000)
        script = script.replace("/* global SHADERS */", "")  # here it is declared
        self.assertEqual(self.complaints(script, "script"), [])


if __name__ == "__main__":
    pages.main()
