"""A scene of 1,000 x 1,000 pixels and 10,000 spheres: its page keeps what it can show, and says what it left out."""
import random

import pages
from eye import EyeTest
from pages import page_of, said, temporary

MOST_BYTES = 10_000_000
SIDE = 1000
SPHERES = 10_000


def large_scene():
    chance = random.Random(1)
    lines = ["[camera]", "eye = [0, 0, 100]", "look_at = [0, 0, 0]", "up = [0, 1, 0]", "near = -30", "left = -20", "right = 20",
             "bottom = -20", "top = 20", f"width = {SIDE}", f"height = {SIDE}"]
    for _ in range(SPHERES):
        x, y, z, r = (chance.uniform(low, high) for low, high in ((-60, 60), (-60, 60), (-60, 40), (0.2, 1)))
        lines += ["[[sphere]]", f"centre = [{x!r}, {y!r}, {z!r}]", f"radius = {r!r}"]
    return temporary("large.toml", "\n".join(lines))


class Large(EyeTest):
    def test_a_large_scene_opens_and_says_what_was_left_out(self):
        scene = large_scene()
        page = page_of(scene)
        self.assertLessEqual(page.stat().st_size, MOST_BYTES)
        said(f"{SIDE} x {SIDE} pixels, {SPHERES} spheres: {page.stat().st_size / 1e6:.2f} MB, open in {self.open(page):.2f} s")
        left_out, drawn = self.run_script("""const { store } = raycheckPage;
          return [store.document.left_out, store.scene().figure.spheres.centre.length];""")
        told = self.text("footer")
        for sentence in left_out:
            self.assertIn(sentence, told)
        steps = [sentence for sentence in left_out if "steps are shown of" in sentence]
        self.assertEqual(len(steps), 1)
        self.assertIn(f"of {SIDE * SIDE} rays; `raycheck view --pixel I,J` asks for others", steps[0])
        self.assertEqual(drawn < SPHERES, any("spheres are drawn" in sentence for sentence in left_out))
        if self.run_script("return raycheckPage.store.scene().seen !== null") and drawn == SPHERES:
            self.assertLess(self.check_eye(scene), SIDE * SIDE / 1000)

    def test_what_was_left_out_is_shown_when_asked_for(self):
        page = page_of(large_scene(), "--pixel", "123,456")
        self.open(page)
        self.assertEqual(self.selection()["pixel"], [123, 456])
        self.assertTrue(self.text("#explain-text").startswith("pixel (123, 456)"))


if __name__ == "__main__":
    pages.main()
