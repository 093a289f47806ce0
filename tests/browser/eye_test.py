"""The view from the eye of what is hard to draw: far, tiny, huge, behind, around the eye; mirrored and turned cameras."""
import pages
from eye import EyeTest
from pages import page_of, temporary

CAMERA = {"eye": "[0, 0, 0]", "look_at": "[0, 0, -1]", "up": "[0, 1, 0]", "near": -1, "left": -1, "right": 1, "bottom": -0.75,
          "top": 0.75, "width": 60, "height": 45}
NEAR_ONES = [("[0.5, 0.25, -4]", 1.5), ("[-0.75, -0.5, -3]", 0.75), ("[0, 0.5, -8]", 3)]
MIRRORED = {"left": 1, "right": -1}
FLIPPED = {"bottom": 0.75, "top": -0.75}
# Of each: changes of the camera, the conventions, the spheres.
CASES = {
    "plain": ({}, {}, NEAR_ONES),
    "mirrored": (MIRRORED, {}, NEAR_ONES),
    "flipped": (FLIPPED, {}, NEAR_ONES),
    "turned": ({**MIRRORED, **FLIPPED}, {"rows": "top-first"}, NEAR_ONES),
    "top-first": ({}, {"rows": "top-first"}, NEAR_ONES),
    "centres": ({"width": 7, "height": 5}, {"samples": "centres"}, NEAR_ONES),
    "centres-top-first": ({}, {"samples": "centres", "rows": "top-first"}, NEAR_ONES),
    "near-positive": ({"near": 1}, {}, [("[0.5, 0.25, 4]", 1.5), ("[-0.75, -0.5, 3]", 0.75), ("[0.5, 0.25, -4]", 2)]),
    "near-positive-mirrored": ({"near": 1, **MIRRORED}, {"rows": "top-first"}, [("[0.5, 0.25, 4]", 1.5), ("[0, 0, 8]", 4)]),
    "tilted": ({"eye": "[3, 2, 1]", "look_at": "[0.5, 0.1, -4]", "up": "[0.3, 1, 0.2]", "near": -0.5}, {}, NEAR_ONES),
    "not-centred": ({"left": 0.1, "right": 0.9, "bottom": -0.5, "top": -0.1}, {}, [("[2, -1, -4]", 0.8)]),
    "around-eye": ({}, {}, [("[0.1, 0.2, 0.3]", 2), ("[0, 0, -1.75]", 0.25)]),
    "around-eye-before-plane": ({}, {}, [("[0, 0, 0]", 0.5), ("[0, 0, -3]", 0.5)]),
    "around-eye-focal": ({}, {"origin": "focal"}, [("[0, 0, 0]", 0.5), ("[0, 0, -3]", 0.5)]),
    "between-eye-and-plane": ({}, {}, [("[0.05, 0, -0.5]", 0.1), ("[0, 0, -4]", 1)]),
    "between-eye-and-plane-focal": ({}, {"origin": "focal"}, [("[0.05, 0, -0.5]", 0.1), ("[0, 0, -4]", 1)]),
    "cut-by-plane": ({}, {}, [("[0.2, 0, -1]", 0.3), ("[0, 0, -4]", 1)]),
    "cut-by-plane-smaller-root": ({}, {"root": "smaller"}, [("[0.2, 0, -1]", 0.3), ("[0, 0, -4]", 1)]),
    "behind": ({}, {}, [("[0, 0, 4]", 1), ("[0.5, 0, 1.05]", 1)]),
    "far": ({"left": -1.5e-8, "right": 1.5e-8, "bottom": -1.2e-8, "top": 1.2e-8}, {}, [("[0.25, 0.125, -1e8]", 1)]),
    "farther": ({"left": -1.5e-14, "right": 1.5e-14, "bottom": -1.2e-14, "top": 1.2e-14}, {},
                [("[0.25, 0.125, -1e14]", 1), ("[-1, 0.125, -1e14]", 0.4)]),
    "large": ({"eye": "[1e160, 0, 0]", "look_at": "[1e160, 0, -1e160]", "near": -1e160, "left": -1e160, "right": 1e160,
               "bottom": -7.5e159, "top": 7.5e159}, {}, [("[1.5e160, 2.5e159, -4e160]", 1.5e160), ("[0, 0, -3e160]", 1e158)]),
    "small": ({"near": -1e-200, "left": -1e-200, "right": 1e-200, "bottom": -7.5e-201, "top": 7.5e-201}, {},
              [("[5e-201, 2.5e-201, -4e-200]", 1.5e-200), ("[-1, 0, -4]", 1)]),
    "wide": ({"left": -1e6, "right": 1e6, "bottom": -7.5e5, "top": 7.5e5}, {}, [("[1e6, 2, -1.5]", 2e5), ("[0, 0, -3]", 2.999)]),
    "grazing-a-plane-of-a-sphere": ({}, {}, [("[0, -1e7, -4]", 1e7 - 0.25)]),
    "two-large-that-cross": ({}, {}, [("[0, -100.5, -4]", 100), ("[0, 100.5, -6]", 100), ("[0.25, 0, -4]", 0.4)]),
    "nested": ({}, {}, [("[0, 0, -4]", 1.5), ("[0.1, 0, -4]", 1.2), ("[0, 0, -3]", 0.7)]),
    "t-min": ({}, {"t_min": 2.5}, NEAR_ONES),
    "t-max": ({}, {"t_max": 3}, NEAR_ONES),
    "culled-back": ({}, {"culling": '"back-faces"'}, [("[0, 0, 0]", 2), ("[0.5, 0, -4]", 1)]),
    "culled-front": ({}, {"culling": '"front-faces"'}, NEAR_ONES),
}


def scene_text(changes, conventions, spheres):
    lines = ["[camera]", *(f"{key} = {value}" for key, value in {**CAMERA, **changes}.items()), "[conventions]"]
    for key, value in conventions.items():
        lines.append(f'{key} = "{value}"' if isinstance(value, str) and not value.startswith('"') else f"{key} = {value}")
    for centre, radius in spheres:
        lines += ["[[sphere]]", f"centre = {centre}", f"radius = {radius}"]
    return "\n".join(lines)


class Eye(EyeTest):
    def test_the_view_from_the_eye_is_the_certified_picture_but_at_outlines(self):
        for name, case in CASES.items():
            with self.subTest(name):
                scene = temporary(f"{name}.toml", scene_text(*case))
                self.open(page_of(scene, "--method", "cross"))
                pixels = self.run_script("return raycheckPage.store.scene().figure.camera.width * raycheckPage.store.scene().figure.camera.height")
                self.assertLess(self.check_eye(scene), pixels / 50)


if __name__ == "__main__":
    pages.main()
