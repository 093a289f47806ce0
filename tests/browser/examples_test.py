"""Every shipped scene as a page: the page opens and is small, and its view from the eye agrees with `raycheck image`."""
import pages
from eye import EyeTest
from pages import EXAMPLES, page_of, said

MOST_BYTES = 1_500_000  # for 16 x 16 pixels and ten spheres
MOST_BYTES_LARGE = 10_000_000


class Examples(EyeTest):
    def test_every_scene_opens_and_is_right_from_the_eye(self):
        for scene in EXAMPLES:
            with self.subTest(scene.name):
                page = page_of(scene)
                seconds = self.open(page)
                size = page.stat().st_size
                said(f"{scene.name}: {size / 1e6:.2f} MB, open in {seconds:.2f} s")
                camera, spheres, left_out = self.run_script("""const { figure } = raycheckPage.store.scene();
                  return [figure.camera, figure.spheres.centre.length, raycheckPage.store.document.left_out];""")
                is_small = spheres <= 10 and (camera is None or camera["width"] * camera["height"] <= 256)
                self.assertLessEqual(size, MOST_BYTES if is_small else MOST_BYTES_LARGE)
                for sentence in left_out:
                    self.assertIn(sentence, self.text("footer"))
                self.check_what_is_there(scene.name, camera)
                if camera is not None:
                    self.check_seen(scene)
                    self.check_eye(scene, camera["width"], camera["height"])
                    self.check_eye(scene, 9 * camera["width"] + 1, 9 * camera["height"] + 1)

    def check_what_is_there(self, name, camera):
        self.assertIn(name, self.text("#title"))
        self.assertTrue(self.text("#headline .sentence").endswith("."))
        self.assertEqual(self.text("#panel-heading"), "Step by step")
        self.assertGreater(self.run_script("return document.querySelectorAll('#steps > .step').length"), 2)
        shown = self.run_script("""const canvas = document.querySelector("#figure-view canvas");
          return [canvas.checkVisibility(), canvas.width > 100, document.querySelector("#picture").checkVisibility()];""")
        self.assertEqual(shown, [True, True, camera is not None])


if __name__ == "__main__":
    pages.main()
