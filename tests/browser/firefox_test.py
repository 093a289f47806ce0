"""Pages in Firefox: they open, make no requests, and show what they show in Chromium."""
import shlex
import unittest

import firefox
import pages
import webdriver
from eye import DRAWN
from pages import ROOT, page_of, ran, temporary

SCENES = [ROOT / "scene/examples" / name for name in ("far-sphere.toml", "ten-spheres.toml", "lecture-examples.toml")]
ASKED = "return performance.getEntriesByType('resource').map((one) => one.name)"


class InFirefox(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if reason := webdriver.missing(("firefox-esr firefox", "Xvfb"), "firefox-esr xvfb"):
            raise unittest.SkipTest(reason)
        try:
            cls.browser = firefox.Firefox()
        except (OSError, RuntimeError) as problem:
            raise unittest.SkipTest(f"Firefox does not start here: {problem}") from problem

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def open(self, path):
        self.browser.open(path)
        self.browser.run("return window.raycheckPage.ready.then(() => null)")
        self.assertEqual(self.browser.run(ASKED), [])

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).textContent", selector)

    def test_a_page_agrees_with_explain(self):
        for scene in SCENES:
            with self.subTest(scene.name):
                self.open(page_of(scene))
                self.assertTrue(self.text("#headline .sentence").endswith("."))
                command = self.browser.run("return raycheckPage.store.panel().command")
                self.assertEqual(self.text("#explain-text"), ran(*shlex.split(command)[1:]))

    def test_the_view_from_the_eye_is_the_certified_picture(self):
        for scene in SCENES[:2]:
            with self.subTest(scene.name):
                self.open(page_of(scene))
                if not self.browser.run("return Boolean(document.createElement('canvas').getContext('webgl2'))"):
                    self.skipTest("Firefox gives no WebGL 2 here: apt-get install libegl1 libgl1-mesa-dri")
                width, height, seen = self.browser.run("""const { figure, seen } = raycheckPage.store.scene();
                  return [figure.camera.width, figure.camera.height,
                    seen.flatMap(([run, sphere]) => Array(run).fill(sphere))];""")
                self.assertGreater(len(set(seen)), 1)
                self.assertEqual(self.browser.run(DRAWN, width, height), seen)

    def test_a_chart_has_every_method(self):
        page = temporary("chart.html")
        ran("stress", "--family", "distance", "--cases", "20", "--view", page)
        self.open(page)
        names = self.browser.run("return [...document.querySelectorAll('#chart-methods button')].map((one) => one.textContent)")
        for method in ("cross", "quadratic", "robust"):
            self.assertTrue(any(name.startswith(method) for name in names), names)


if __name__ == "__main__":
    pages.main()
