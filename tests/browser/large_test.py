"""Scenes of many pixels and many spheres: their pages show a part, and say what they leave out."""
import random

import pages
from eye import EyeTest
from pages import page_of, said, temporary

MOST_BYTES = 10_000_000
MOST_TOLD_APART = 10  # spheres, by their colours
SIZES = {"many-pixels": (1000, 10), "large": (1000, 10_000)}  # pixels across and down, spheres


def large_scene(name, side, spheres):
    chance = random.Random(1)
    lines = ["[camera]", "eye = [0, 0, 100]", "look_at = [0, 0, 0]", "up = [0, 1, 0]", "near = -30", "left = -20", "right = 20",
             "bottom = -20", "top = 20", f"width = {side}", f"height = {side}"]
    for _ in range(spheres):
        x, y, z, r = (chance.uniform(low, high) for low, high in ((-60, 60), (-60, 60), (-60, 40), (0.2, 1)))
        lines += ["[[sphere]]", f"centre = [{x!r}, {y!r}, {z!r}]", f"radius = {r!r}"]
    return temporary(f"{name}.toml", "\n".join(lines))


class Large(EyeTest):
    def test_a_large_scene_opens_and_reports_what_was_left_out(self):
        for name, (side, spheres) in SIZES.items():
            with self.subTest(name):
                self.check_large(large_scene(name, side, spheres), side, spheres)

    def check_large(self, scene, side, spheres):
        page = page_of(scene)
        self.assertLessEqual(page.stat().st_size, MOST_BYTES)
        said(f"{side} x {side} pixels, {spheres} spheres: {page.stat().st_size / 1e6:.2f} MB, open in {self.open(page):.2f} s")
        left_out, drawn = self.run_script("""const { store } = raycheckPage;
          return [store.document.left_out, store.scene().figure.spheres.centre.length];""")
        told = self.text("footer")
        for sentence in left_out:
            self.assertIn(sentence, told)
        steps = [sentence for sentence in left_out if f" of {side * side} rays are shown; `raycheck view --pixel I,J` shows others" in sentence]
        self.assertEqual(len(steps), 1, left_out)
        self.assertEqual(drawn < spheres, any("spheres are drawn" in sentence for sentence in left_out))
        if spheres <= MOST_TOLD_APART:
            self.assertGreater(self.check_eye(scene, 300, 300), 0)

    def test_panels_that_were_left_out_can_be_requested(self):
        self.open(page_of(large_scene("asked", *SIZES["many-pixels"]), "--pixel", "123,456"))
        self.assertEqual(self.selection()["pixel"], [123, 456])
        self.assertTrue(self.text("#explain-text").startswith("pixel (123, 456)"))

    def test_without_a_panel_the_page_shows_the_command_for_it(self):
        self.open(page_of(large_scene("asked", *SIZES["many-pixels"])))
        self.run_script("raycheckPage.store.set({ selection: { pixel: [123, 457], sphere: null } })")
        self.assertIn("--pixel 123,457", self.text("#no-panel"))


if __name__ == "__main__":
    pages.main()
