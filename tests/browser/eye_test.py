"""The view from the eye: spheres that are far, tiny, huge, behind or around the eye; mirrored and turned cameras."""
import pages
from eye import EyeTest
from pages import page_of, temporary

CAMERA = {"eye": "[0, 0, 0]", "look_at": "[0, 0, -1]", "up": "[0, 1, 0]", "near": -1, "left": -1, "right": 1, "bottom": -0.75,
          "top": 0.75, "width": 3, "height": 2}
SIZE = (80, 60)  # pixels that are compared: few, so that the page is made quickly
NEAR_ONES = [("[0.5, 0.25, -4]", 1.5), ("[-0.75, -0.5, -3]", 0.75), ("[0, 0.5, -8]", 3)]
MIRRORED = {"left": 1, "right": -1}
FLIPPED = {"bottom": 0.75, "top": -0.75}
# For each: changes of the camera, the conventions, the spheres, and the number of spheres that are
# seen.
CASES = {
    "plain": ({}, {}, NEAR_ONES, 3),
    "mirrored": (MIRRORED, {}, NEAR_ONES, 3),
    "flipped": (FLIPPED, {}, NEAR_ONES, 3),
    "turned": ({**MIRRORED, **FLIPPED}, {"rows": "top-first"}, NEAR_ONES, 3),
    "top-first": ({}, {"rows": "top-first"}, NEAR_ONES, 3),
    "centres": ({}, {"samples": "centres"}, NEAR_ONES, 3),
    "centres-top-first": ({}, {"samples": "centres", "rows": "top-first"}, NEAR_ONES, 3),
    "near-positive": ({"near": 1}, {}, [("[0.5, 0.25, 4]", 1.5), ("[-0.75, -0.5, 3]", 0.75), ("[0.5, 0.25, -4]", 2)], 2),
    "near-positive-mirrored": ({"near": 1, **MIRRORED}, {"rows": "top-first"}, [("[0.5, 0.25, 4]", 1.5), ("[0, 0, 8]", 4)], 2),
    "tilted": ({"eye": "[3, 2, 1]", "look_at": "[0.5, 0.1, -4]", "up": "[0.3, 1, 0.2]", "near": -0.5}, {}, NEAR_ONES, 3),
    "not-centred": ({"left": 0.1, "right": 0.9, "bottom": -0.5, "top": -0.1}, {}, [("[2, -1, -4]", 0.8)], 1),
    "around-eye": ({}, {}, [("[0.1, 0.2, 0.3]", 2), ("[0, 0, -1.75]", 0.25)], 2),
    "around-eye-before-plane": ({}, {}, [("[0, 0, 0]", 0.5), ("[0, 0, -3]", 0.5)], 1),
    "around-eye-focal": ({}, {"origin": "focal"}, [("[0, 0, 0]", 0.5), ("[0, 0, -3]", 0.5)], 1),
    "between-eye-and-plane": ({}, {}, [("[0.05, 0, -0.5]", 0.1), ("[0, 0, -4]", 1)], 1),
    "between-eye-and-plane-focal": ({}, {"origin": "focal"}, [("[0.05, 0, -0.5]", 0.1), ("[0, 0, -4]", 1)], 2),
    "cut-by-plane": ({}, {}, [("[0.2, 0, -1]", 0.3), ("[0, 0, -4]", 1)], 2),
    "cut-by-plane-smaller-root": ({}, {"root": "smaller"}, [("[0.2, 0, -1]", 0.3), ("[0, 0, -4]", 1)], 1),
    "behind": ({}, {}, [("[0, 0, 4]", 1), ("[0.5, 0, 1.05]", 1)], 0),
    "far": ({"left": -1.5e-8, "right": 1.5e-8, "bottom": -1.2e-8, "top": 1.2e-8}, {}, [("[0.25, 0.125, -1e8]", 1)], 1),
    "farther": ({"left": -1.5e-14, "right": 1.5e-14, "bottom": -1.2e-14, "top": 1.2e-14}, {},
                [("[0.25, 0.125, -1e14]", 1), ("[-1, 0.125, -1e14]", 0.4)], 2),
    "large": ({"eye": "[1e160, 0, 0]", "look_at": "[1e160, 0, -1e160]", "near": -1e160, "left": -1e160, "right": 1e160,
               "bottom": -7.5e159, "top": 7.5e159}, {}, [("[1.5e160, 2.5e159, -4e160]", 1.5e160), ("[0, 0, -3e160]", 2e159)], 2),
    "small": ({"near": -1e-200, "left": -1e-200, "right": 1e-200, "bottom": -7.5e-201, "top": 7.5e-201}, {},
              [("[5e-201, 2.5e-201, -4e-200]", 1.5e-200), ("[-1e-180, 0, -4e-180]", 1e-180)], 2),
    "wide": ({"left": -1e6, "right": 1e6, "bottom": -7.5e5, "top": 7.5e5}, {}, [("[1e6, 2, -1.5]", 2e5), ("[0, 0, -3]", 2.999)], 1),
    "grazing-a-plane-of-a-sphere": ({}, {}, [("[0, -1e5, -4]", 1e5 - 0.25)], 1),
    "two-large-that-cross": ({}, {}, [("[0, -100.5, -4]", 100), ("[0, 100.5, -6]", 100), ("[0.25, 0, -4]", 0.4)], 3),
    "nested": ({}, {}, [("[0, 0, -4]", 1.5), ("[0.1, 0, -4]", 1.2), ("[0, 0, -3]", 0.7)], 2),
    "t-min": ({}, {"t_min": 2.5}, NEAR_ONES, 3),
    "t-max": ({}, {"t_max": 3}, NEAR_ONES, 2),
    "culled-back": ({}, {"culling": '"back-faces"'}, [("[0, 0, 0]", 2), ("[0.5, 0, -4]", 1)], 1),
    "culled-front": ({}, {"culling": '"front-faces"'}, [("[0, 0, -4]", 1.5), ("[0.2, 0, -4.5]", 0.5)], 2),
}


def scene_text(changes, conventions, spheres):
    lines = ["[camera]", *(f"{key} = {value}" for key, value in {**CAMERA, **changes}.items()), "[conventions]"]
    for key, value in conventions.items():
        lines.append(f'{key} = "{value}"' if isinstance(value, str) and not value.startswith('"') else f"{key} = {value}")
    for centre, radius in spheres:
        lines += ["[[sphere]]", f"centre = {centre}", f"radius = {radius}"]
    return "\n".join(lines)


class Eye(EyeTest):
    def test_the_view_from_the_eye_is_the_certified_picture_except_at_outlines(self):
        for name, (*case, seen) in CASES.items():
            with self.subTest(name):
                scene = temporary(f"{name}.toml", scene_text(*case))
                self.open(page_of(scene, "--method", "cross"))
                self.assertEqual(self.check_eye(scene, *SIZE), seen)

    def test_a_sphere_too_far_to_be_drawn_is_reported(self):
        scene = temporary("too-far.toml", scene_text({}, {}, [("[0, 0, -1e32]", 5e31)]))
        self.open(page_of(scene, "--method", "cross"))
        note = self.run_script("""raycheckPage.store.set({ layers: { hits: false, roots: false, names: false, rays: "none" } });
          const look = document.querySelector("#figure-look");
          look.value = "eye";
          look.dispatchEvent(new Event("change", { bubbles: true }));
          return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() =>
            done(document.querySelector("#figure-view [role=status]").textContent))));""")
        self.assertIn("1e30 times as far as the nearest are not drawn", note)


if __name__ == "__main__":
    pages.main()
