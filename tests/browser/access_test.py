"""axe-core finds no violations: with camera, given rays, findings and dial, and on the pages of a grade; dark and light; narrow and wide."""
import unittest

import pages
from pages import NPM, PageTest, ROOT, page_of, ran, temporary

AXE = NPM / "axe-core/axe.min.js"
WIDTHS = (390, 1400)
SCHEMES = ("light", "dark")
PAGES = {
    "findings": (ROOT / "scene/examples/far-sphere.toml",),
    "given rays": (ROOT / "scene/examples/tangent-and-neighbours.toml",),
    "dial": ("--family", "distance", "--method", "quadratic,cross"),
}
GRADED = ("nils", "jana", "zoe")  # of functions, of nothing that runs, of pictures, one of them a program's that fails
RUN = """return axe.run(document, { resultTypes: ["violations"] }).then(({ violations, passes }) => [passes.length,
  violations.flatMap((one) => one.nodes.map((node) => `${one.id}: ${node.target} ${node.failureSummary}`))]);"""


@unittest.skipUnless(AXE.exists(), "there is no axe-core here: ./run packages ci")
class Accessibility(PageTest):
    def violations(self):
        passes, found = self.run_script(f"{AXE.read_text()};\n{RUN}")
        self.assertGreater(passes, 5)
        return found

    def look_like(self, scheme, width):
        self.browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.browser.command("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)

    def tearDown(self):
        super().tearDown()
        self.browser.command("Emulation.clearDeviceMetricsOverride")
        self.browser.command("Emulation.setEmulatedMedia", features=[])

    def test_broken_pages_are_found(self):
        self.browser.open(temporary("broken.html", "<!doctype html><title>x</title><p style='color: #ddd; background: #fff'>pale words</p><img src='data:,'><input>"))
        found = " ".join(self.violations()) + " "
        for rule in ("color-contrast", "image-alt", "label", "html-has-lang"):
            self.assertIn(rule, found)

    def look_at_all_of(self, name):
        self.run_script("for (const one of document.querySelectorAll('details')) one.open = true;")
        for scheme in SCHEMES:
            for width in WIDTHS:
                with self.subTest(f"{name}, {scheme}, {width}"):
                    self.look_like(scheme, width)
                    self.run_script("return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
                    self.assertEqual(self.run_script("return matchMedia('(prefers-color-scheme: dark)').matches"), scheme == "dark")
                    self.assertEqual(self.violations(), [])
                    self.assertEqual(self.run_script("return document.documentElement.scrollWidth - document.documentElement.clientWidth"), 0)

    def test_every_kind_of_page_in_every_look(self):
        for name, arguments in PAGES.items():
            self.open(page_of(*arguments))
            self.look_at_all_of(name)

    def test_pages_of_a_grade_in_every_look(self):
        out = temporary("graded")
        ran("grade", "lecture7", *(ROOT / "tests/submissions/class" / name for name in GRADED), "--out", out, "--sandbox", "available")
        for page in ["index.html", *(f"{name}/report.html" for name in GRADED)]:
            self.browser.open(out / page)
            self.look_at_all_of(page)


if __name__ == "__main__":
    pages.main()
