"""A page in use: clicks, keys, findings, methods, the divider, the dial; with and without WebGL."""
import math
import unittest

import pages
import webdriver
from pages import PageTest, ROOT, page_of, ran

FAR = ROOT / "scene/examples/far-sphere.toml"
TOP_FIRST = ROOT / "scene/examples/example-6-top-first.toml"
BOTTOM_FIRST = ROOT / "scene/examples/example-6-bottom-first.toml"
TEN = ROOT / "scene/examples/ten-spheres.toml"
GIVEN = ROOT / "scene/examples/lecture-examples.toml"


class Use(PageTest):
    def picture_click(self, i, row):
        """Clicks the middle of the picture's cell in column i and row `row` from the top."""
        width, height, across, down = self.run_script("""const { camera } = raycheckPage.store.scene().figure;
          const view = document.querySelector("#picture-view");
          return [camera.width, camera.height, view.clientWidth, view.clientHeight];""")
        self.browser.click_at("#picture-view", ((i + 0.5) / width - 0.5) * across, ((row + 0.5) / height - 0.5) * down)

    def check_shown(self, pixel):
        """Checks that all parts of the page show this pixel."""
        self.assertEqual(self.selection()["pixel"], pixel)
        place = f"pixel ({pixel[0]}, {pixel[1]})"
        self.assertTrue(self.text("#headline .place").startswith(place), self.text("#headline .place"))
        self.assertTrue(self.text("#picture-place").startswith(place), self.text("#picture-place"))
        self.assertTrue(self.text("#explain-text").startswith(place))
        self.assertEqual(self.run_script("return [...document.querySelectorAll('#pixel-i, #pixel-j')].map((one) => one.valueAsNumber)"), pixel)

    def test_clicks_on_the_picture_choose_the_pixel_whichever_row_is_first(self):
        for scene, is_top_first in ((TOP_FIRST, True), (BOTTOM_FIRST, False)):
            self.open(page_of(scene))
            for i, row in ((0, 0), (15, 8), (3, 2), (12, 7)):
                with self.subTest(f"{scene.name} ({i}, {row})"):
                    self.picture_click(i, row)
                    self.check_shown([i, row if is_top_first else 8 - row])

    def test_the_pictures_colours_agree_with_the_panels(self):
        """Every pixel of the certified picture is lit if and only if its panel has a hit."""
        for scene in (TOP_FIRST, BOTTOM_FIRST):
            self.open(page_of(scene))
            lit = self.run_script("""const image = document.querySelector("#picture-view img");
              const canvas = document.createElement("canvas");
              [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
              const context = canvas.getContext("2d");
              context.drawImage(image, 0, 0);
              const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
              return [...Array(canvas.width * canvas.height).keys()].map((k) => [...data.slice(4 * k, 4 * k + 3)].join());""")
            background = lit[0]
            hits = self.run_script("""const { panels } = raycheckPage.store.scene();
              return Object.fromEntries(panels.map((panel) => [panel.pixel.join(), panel.exact?.s != null]));""")
            for k, colour in enumerate(lit):
                i, row = k % 16, k // 16
                j = row if scene == TOP_FIRST else 8 - row
                self.assertEqual(colour != background, hits[f"{i},{j}"], (scene.name, i, row))

    def test_arrow_keys_move_in_the_pictures_directions(self):
        for scene, up in ((TOP_FIRST, -1), (BOTTOM_FIRST, 1)):
            for target in ("#picture-view", ".figure-stage"):
                with self.subTest(f"{scene.name} {target}"):
                    self.open(page_of(scene))
                    self.run_script("""raycheckPage.store.set({ selection: { pixel: [7, 4] } });
                      document.querySelector(arguments[0]).focus();""", target)
                    self.browser.press("ArrowRight")
                    self.check_shown([8, 4])
                    self.browser.press("ArrowUp", "ArrowUp")
                    self.check_shown([8, 4 + 2 * up])
                    self.browser.press("ArrowDown", "ArrowLeft", "ArrowLeft")
                    self.check_shown([6, 4 + up])
                    self.browser.press("ArrowRight", hold="Shift")
                    self.check_shown([15, 4 + up])
                    self.browser.press("ArrowUp", hold="Shift")
                    self.check_shown([15, 0 if up < 0 else 8])

    def test_arrow_keys_walk_along_given_rays(self):
        self.open(page_of(GIVEN))
        self.run_script("""raycheckPage.store.set({ selection: { ray: 0 } });
          document.querySelector(".figure-stage").focus();""")
        for ray, key in ((1, "ArrowRight"), (2, "ArrowDown"), (2, "ArrowRight"), (1, "ArrowUp"), (0, "ArrowLeft"), (0, "ArrowLeft")):
            self.browser.press(key)
            self.assertEqual(self.selection()["ray"], ray)
            self.assertTrue(self.text("#headline .place").startswith(f"ray {ray}"))

    def test_a_click_on_a_pixel_in_the_figure_from_the_eye_chooses_it(self):
        for scene in (TOP_FIRST, BOTTOM_FIRST):
            self.open(page_of(scene))
            self.choose("#figure-look", "eye")
            across, down = self.run_script("const stage = document.querySelector('.figure-stage'); return [stage.clientWidth, stage.clientHeight];")
            size = min(across / 16, down / 9)  # of a pixel's cell
            for i, row in ((4, 2), (11, 6), (8, 4)):
                with self.subTest(f"{scene.name} ({i}, {row})"):
                    self.browser.click_at(".figure-stage", (i - 7.5) * size, (row - 4) * size)
                    self.check_shown([i, row if scene == TOP_FIRST else 8 - row])

    def viewer(self):
        """The viewpoint of the figure, and the extent of its window."""
        return self.run_script("""return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() =>
          done(raycheckPage.figure.panes[0].viewer))));""")

    def test_the_figure_is_turned_moved_and_zoomed(self):
        """Mouse and keys move the figure without choosing another pixel; the wheel scrolls the page until the figure has the focus."""
        self.open(page_of(TEN))
        before, chosen = self.viewer(), self.selection()
        self.browser.wheel(".figure-stage", -100)
        self.assertEqual(self.viewer(), before)
        steps = {"turned": lambda: self.browser.drag(".figure-stage", 40, 25), "turned by a key": lambda: self.browser.press("a"),
                 "nearer": lambda: self.browser.wheel(".figure-stage", -100), "nearer by a key": lambda: self.browser.press("+")}
        for name, step in steps.items():
            with self.subTest(name):
                step()
                after = self.viewer()
                is_nearer = after["nearest"] < 0.97 * before["nearest"]
                self.assertEqual(is_nearer, name.startswith("nearer"), (before["nearest"], after["nearest"]))
                self.assertEqual(math.dist(after["axes"][2], before["axes"][2]) > 0.01, name.startswith("turned"))
                self.assertAlmostEqual(math.hypot(*after["axes"][0]), 1, delta=1e-9)
                before = after
        self.browser.press("0")
        self.assertAlmostEqual(self.viewer()["axes"][2][1], -math.sin(0.45), delta=1e-6)
        self.assertEqual(self.selection(), chosen)

    def choose(self, selector, value):
        self.run_script("""const field = document.querySelector(arguments[0]);
          field.value = arguments[1];
          field.dispatchEvent(new Event(field.type === "range" ? "input" : "change", { bubbles: true }));
          return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));""", selector, value)

    def test_the_page_opens_at_the_worst_and_findings_go_to_their_place(self):
        self.open(page_of(FAR))
        findings = self.run_script("return raycheckPage.store.document.findings")
        first = findings[0]
        self.assertEqual(self.selection(), {"pixel": first["pixel"], "ray": first["ray"], "sphere": first["sphere"]})
        self.assertEqual(self.run_script("return document.querySelectorAll('#findings button').length"), len(findings))
        for k in (1, 3, len(findings) - 1):
            self.browser.click(f"#findings li:nth-child({k + 1}) button")
            self.check_shown(findings[k]["pixel"])
            self.assertIn(findings[k]["method"] or "", self.text("#headline"))
            self.assertEqual(self.run_script("return document.querySelector(`#findings li:nth-child(${arguments[0]}) button`).ariaCurrent", k + 1), "true")

    def test_an_address_opens_a_finding_and_no_other_address_does(self):
        self.open(page_of(FAR, "--method", "quadratic"), "#finding-3")
        findings = self.run_script("return raycheckPage.store.document.findings")
        self.check_shown(findings[2]["pixel"])
        go = """window.location.hash = arguments[0];
          return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));"""
        for k in (1, len(findings) - 1):
            self.run_script(go, f"#finding-{k + 1}")
            self.check_shown(findings[k]["pixel"])
        for address in ("#finding-0", f"#finding-{len(findings) + 1}", "#finding-2x", "#panel", "#finding-<b>", "#"):
            self.run_script(go, address)
            self.check_shown(findings[-1]["pixel"])

    def test_the_headline_names_the_wrong_method_and_its_step(self):
        self.open(page_of(FAR))
        self.run_script("raycheckPage.store.set({ selection: { pixel: [9, 8] }, methodShown: 'quadratic' })")
        for word in ("quadratic", "goes wrong at", "6.7e+07 ulp"):
            self.assertIn(word, self.text("#headline"))
        self.assertEqual(self.run_script("return [...document.querySelectorAll('.wrong-step')].map((one) => one.dataset.symbol)")[0], "d^2")

    def test_one_method_or_all_are_shown(self):
        self.open(page_of(FAR))
        self.choose("#pixel-i", "9")
        self.choose("#pixel-j", "8")
        self.check_shown([9, 8])
        everyone = self.run_script("return [...new Set(raycheckPage.store.panel().verdicts.map((one) => one.name))]")
        chips = self.run_script("return [...document.querySelectorAll('#methods .chip')].map((one) => [one.id, one.lastChild.textContent])")
        self.assertEqual(sorted(name for _, name in chips), sorted([*everyone, "all methods"]))
        for identity, name in chips:
            if name == "all methods":
                continue
            self.browser.click(f"#{identity}")
            rows = self.run_script("return [...document.querySelectorAll('#steps .values tbody th, #verdicts dt')].map((one) => one.textContent)")
            self.assertEqual({row.replace("\u2717 ", "") for row in rows}, {name})
            self.assertEqual(self.run_script("return document.querySelectorAll('#methods [aria-pressed=true]').length"), 1)
        self.browser.click("#method-all")
        self.assertEqual(self.run_script("return raycheckPage.store.methodShown"), None)

    def test_the_divider_separates_the_pictures(self):
        self.open(page_of(FAR))
        for percent in (0, 37, 100):
            self.choose("#divider", str(percent))
            clip, line = self.run_script("""return [document.querySelectorAll("#picture-view img")[1].style.clipPath,
              document.querySelector("#picture-view .divider").getAttribute("x1")];""")
            self.assertEqual((clip.replace("0px", "0"), line), (f"inset(0 0 0 {percent}%)", f"{percent}%"))

    def test_every_picture_can_be_chosen_on_either_side(self):
        self.open(page_of(FAR))
        pictures = self.run_script("return raycheckPage.store.scene().pictures.map(({ png }) => png)")
        self.assertGreater(len(pictures), 2)
        for k in (0, len(pictures) - 1):
            for side in ("left", "right"):
                self.choose(f"#picture-{side}", str(k))
                shown = self.run_script("return [...document.querySelectorAll('#picture-view img')].map((one) => [one.src, one.complete && one.naturalWidth])")
                self.assertEqual(shown[side == "right"], [pictures[k], 16])

    def test_a_sphere_is_chosen_among_those_of_a_ray(self):
        self.open(page_of(TEN))
        self.run_script("raycheckPage.store.set({ selection: { ...raycheckPage.store.scene().start } })")
        spheres = self.run_script("return [...document.querySelectorAll('#sphere option')].map((one) => one.value)")
        self.assertGreater(len(spheres), 1)
        for sphere in (spheres[-1], spheres[0]):
            self.choose("#sphere", sphere)
            self.assertEqual(self.selection()["sphere"], int(sphere))
            self.assertIn(f"sphere {sphere}: C = ", self.text("#explain-text"))

    def test_the_window_of_the_microscope_widens(self):
        self.open(page_of(FAR))
        halves = self.run_script("return raycheckPage.store.panel().microscope.zooms.map((zoom) => Number(zoom.half))")
        self.assertGreater(len(halves), 1)
        for k, half in enumerate(halves):
            self.choose("#zoom", str(k))
            label = self.run_script("return document.querySelector('#microscope svg').getAttribute('aria-label')")
            told = float(label.split("within ")[1].split(" ulp")[0])
            self.assertAlmostEqual(told / half, 1, delta=0.05)
            expected, drawn = self.run_script("""const svg = document.querySelector("#microscope svg");
              const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
              const scale = width / 2 / arguments[0];
              const places = raycheckPage.store.panel().microscope.marks
                .map((mark) => [width / 2 + Number(mark.x) * scale, height / 2 - Number(mark.y) * scale])
                .filter(([x, y]) => x >= 0 && x <= width && y > 8 && y < height - 8);
              return [places, [...svg.querySelectorAll("g > .glyph")].map((one) => one.getAttribute("transform").match(/-?[0-9.]+/g).slice(0, 2).map(Number))];""", half)
            self.assertEqual(len(drawn), len(expected))
            for (x, y), (told_x, told_y) in zip(expected, drawn):
                self.assertAlmostEqual(x, told_x, delta=0.1)
                self.assertAlmostEqual(y, told_y, delta=0.1)

    def test_the_dial_steps_and_everything_with_it(self):
        self.open(page_of("--family", "distance", "--method", "quadratic,cross"))
        dial, facet = self.run_script("const { dial, chart } = raycheckPage.store.document; return [dial, chart.facets[0]];")
        self.assertEqual([series["name"] for series in facet["series"]], ["quadratic", "cross"])
        seen = set()
        for k in (0, len(facet["severities"]) - 1, 2):
            self.choose("#severity", str(k))
            scene, text, told = self.run_script("""const { store } = raycheckPage;
              return [store.scenesIndex, store.panel().text, document.querySelector("#severity").ariaValueText];""")
            self.assertEqual(scene, dial["scenes"][k])
            self.assertEqual(told, facet["severities"][k])
            self.assertEqual(self.text("#explain-text"), text)
            self.assertIn(f"severity {told} is shown", self.run_script("return document.querySelector('#dial svg.instrument').getAttribute('aria-label')"))
            seen.add(text)
        self.assertEqual(len(seen), 3)


class WithoutWebGL(unittest.TestCase):
    """The tests above, in a browser without WebGL."""

    def test_a_page_still_has_all_but_the_view_in_space(self):
        if reason := webdriver.missing():
            self.skipTest(reason)
        browser = webdriver.Browser("--disable-3d-apis")
        try:
            for scene in (TOP_FIRST, FAR, GIVEN):
                browser.open(page_of(scene))
                browser.run(pages.READY)
                self.assertEqual(browser.problems(), [])
                self.assertTrue(browser.run("return document.querySelector('#explain-text').textContent.length > 500"))
                self.assertTrue(browser.run("return document.querySelector('#microscope svg.instrument, #microscope p').checkVisibility()"))
                self.assertEqual(browser.run("return document.querySelectorAll('#picture-view img').length"), 0 if scene == GIVEN else 2)
                titles, shapes, canvas, note = browser.run("""const flat = document.querySelector(".figure-flat");
                  return [[...flat.querySelectorAll("text")].map((one) => one.textContent), flat.querySelectorAll("path, circle").length,
                    document.querySelector("#figure-view canvas").checkVisibility(), document.querySelector("#figure-view [role=status]").textContent];""")
                self.assertEqual([title.split(",")[0] for title in titles], ["from the side", "from above"])
                self.assertGreater(shapes, 10)
                self.assertFalse(canvas)
                self.assertIn("does not support WebGL 2", note)
        finally:
            browser.close()


if __name__ == "__main__":
    pages.main()
