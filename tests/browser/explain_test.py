"""A page's text about 39 hard rays: the output of `raycheck explain`, the texts to copy, the microscope."""
import dataclasses
import functools
import json
import shlex
from decimal import Decimal

import pages
from exact import Vector, derivation, ray_of, ulp_of
from pages import PageTest, page_of, ran, temporary

UNIT = ((0, 0, 0), 1)
LEAST = 5e-324  # the smallest double
BELOW_1 = 1 - 2**-53
ABOVE_1 = 1 + 2**-52
# For each page: its rays, its spheres.
GIVEN = {
    "tangent": ([((-5, y, 0), (1, 0, 0)) for y in (1, BELOW_1, ABOVE_1, -1)], [UNIT]),
    "surface": ([((-1, 0, 0), (1, 0, 0)), ((-1, 0, 0), (-1, 0, 0)), ((-1, 0, 0), (0, 1, 0)), ((0.6, 0.8, 0), (-3, 1, 0.5)),
                 ((0, 0, 0), (1, 2, 3)), ((-BELOW_1, 0, 0), (-1, 0, 0)), ((2, 0, 0), (1, 0, 0))], [UNIT]),
    "far": ([((0.5, 0.25, -1e8), (0, 0, 1)), ((0.5, 0.25, -1e15), (0, 0, 1)), ((1, 3, -1e8), (-1e-8, -3e-8, 1))], [UNIT]),
    "grazing": ([((-1e6, 0.9999999999, 0), (1, 0, 0)), ((-1e6, 0.5, 0), (1, 5e-7, 1e-9))], [UNIT]),
    "not-unit": ([((-5, 0.1, 0.2), (1e-5, 0, 0)), ((-5, 0.1, 0.2), (1e100, 1e98, 0)), ((-3, -4, 0.5), (3, 4, -0.1)),
                  ((-5, 0.1, 0.2), (1 / 3, 1e-3, -1e-2))], [UNIT]),
    "large": ([((0, 0, 0), (3, 1, 0.1)), ((-1e160, 2e160, 0), (1, 1e-3, 0)), ((1e-300, 0, 0), (1, 0.4, 0))], [((3e160, 1e160, 0), 1e160)]),
    "small": ([((0, 0, 0), (1, 0, 0)), ((0, 0, 0), (1, 5e-301, 0)), ((1 - 1e-10, 0, 0), (1, 0, 0))], [((1, 5e-301, 0), 1e-300)]),
    "least": ([((0, 0, 0), (1, 0, 0)), ((-1e-300, 0, 0), (1, LEAST, 0))], [((1e-310, 0, 0), LEAST)]),
    "coincident": ([((-5, 0.3, 0.1), (1, 0, 0)), ((0.1, 0, 0), (0, 1, 1))], [UNIT, UNIT]),
}
CAMERAS = {  # for each: its pixels, its camera, its sphere
    "wide": ([(0, 0), (1, 1), (2, 1)], {"eye": (0, 0, 0), "look_at": (0, 0, -1), "up": (0, 1, 0), "near": -1, "left": -1e6,
             "right": 1e6, "bottom": -1e6, "top": 1e6, "width": 3, "height": 3}, ((1e6, 2, -1.5), 3)),
    "tilted": ([(4, 3), (7, 0), (2, 5), (3, 3)], {"eye": (1e3, 0.1, 6), "look_at": (0.25, 0.5, 0), "up": (0.25, 1, 0.3), "near": -2,
               "left": -0.3, "right": 0.25, "bottom": -0.2, "top": 0.3, "width": 8, "height": 6}, ((0.25, 0.5, 0), 40)),
}
CLOSE = Decimal("5e-6")  # relative: the microscope shows six digits
NOTHING = Decimal(2) ** -29  # ulp: smaller distances are shown as 0
NO_SIDE = Decimal("1e-1000")  # a ray that is nearer to the centre counts as passing through it


def triple(values):
    return "[" + ", ".join(map(repr, values)) + "]"


def scene_file(name, spheres, rays=(), camera=None):
    text = "".join(f"[[sphere]]\ncentre = {triple(centre)}\nradius = {radius!r}\n" for centre, radius in spheres)
    text += "".join(f"[[ray]]\norigin = {triple(origin)}\ndirection = {triple(direction)}\n" for origin, direction in rays)
    if camera is not None:
        text += "[camera]\n" + "".join(f"{key} = {triple(value) if isinstance(value, tuple) else repr(value)}\n" for key, value in camera.items())
    return temporary(f"{name}.toml", text)


def hard_rays():
    """(scene's path, selection, arguments of explain, origin, direction, sphere) of every hard ray."""
    for name, (rays, spheres) in GIVEN.items():
        path = scene_file(name, spheres, rays)
        for k, ray in enumerate(rays):
            for number, (centre, radius) in enumerate(spheres):
                arguments = (f"--ray={','.join(map(repr, (*ray[0], *ray[1])))}", f"--sphere={','.join(map(repr, (*centre, radius)))}")
                yield path, {"pixel": None, "ray": k, "sphere": number}, arguments, Vector(ray[0]), Vector(ray[1]), (centre, radius)
    for name, (pixels, camera, sphere) in CAMERAS.items():
        path = scene_file(name, [sphere], camera=camera)
        for i, j in pixels:
            yield path, {"pixel": [i, j], "ray": None, "sphere": None}, (path, "--pixel", f"{i},{j}"), *ray_of(camera, i, j), sphere


@functools.cache
def explained(arguments):
    return json.loads(ran("explain", *arguments, "--format", "json"))


# Presses every copy button, and returns the copied texts by the button's id.
COPY = """const buttons = [...document.querySelectorAll("#panel .copy button")];
  for (const button of buttons) button.click();
  const texts = () => buttons.map((button) => [button.id, button.parentElement.querySelector("textarea")?.value]);
  return new Promise((done) => {
    const look = () => (texts().every(([, text]) => text !== undefined) ? done(Object.fromEntries(texts())) : setTimeout(look, 10));
    look();
  });"""


@dataclasses.dataclass
class Told:
    """The page's text about one ray."""
    name: str
    arguments: tuple  # of explain
    length: Decimal  # of the direction
    exact: dict  # the steps, by their symbols; with s and Q for a hit
    text: str
    microscope: dict
    copied: dict


def rounded_steps(arguments):
    return {step["symbol"]: list(map(float.fromhex, step["rounded"])) for step in explained(arguments)["exact"]["steps"]}


class HardRays(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser.command("Browser.setPermission", permission={"name": "clipboard-write"}, setting="denied")
        cls.told = list(cls.look())
        assert len(cls.told) == 39

    @classmethod
    def look(cls):
        """Opens each page once, and chooses its rays there."""
        opened = None
        for path, selection, arguments, origin, direction, sphere in hard_rays():
            if path != opened:
                cls.open(page_of(path))
                opened = path
            cls.browser.run("raycheckPage.store.set({ selection: arguments[0] })", selection)
            text, microscope = cls.browser.run(
                "return [document.querySelector('#explain-text').textContent, raycheckPage.store.panel().microscope]")
            exact = derivation(origin, direction, sphere, "s" in rounded_steps(arguments))
            yield Told(f"{path.name} {selection}", arguments, direction.norm(), exact, text, microscope, cls.browser.run(COPY))
        cls.check_page()

    def test_the_panel_and_the_command_agree_with_explain(self):
        for told in self.told:
            with self.subTest(told.name):
                self.assertEqual(told.text, ran("explain", *told.arguments))
                program, *words = shlex.split(told.copied["copy-command"])
                self.assertEqual(program, "raycheck")
                self.assertEqual(told.text, ran(*words))

    def test_check_accepts_the_scene(self):
        texts = {told.copied["copy-toml"] for told in self.told}
        self.assertEqual(len(texts), len(GIVEN) + len(CAMERAS))
        for text in texts:
            with self.subTest(text):
                ran("check", temporary("copied.toml", text))

    def test_explain_has_the_exact_values(self):
        for told in self.told:
            with self.subTest(told.name):
                steps = rounded_steps(told.arguments)
                for name, value in told.exact.items():
                    components = [float(x) for x in (value if isinstance(value, Vector) else [value])]
                    if name != "d^2" or steps[name] != [0]:  # of a tangent: no number of digits suffices
                        self.assertEqual(components, steps[name], name)

    def test_the_microscope_has_every_answer_in_its_place(self):
        marks = 0
        for told in self.told:
            if told.microscope is None or "s" not in told.exact:
                continue
            answers = {method["name"]: method for method in explained(told.arguments)["methods"]}
            with self.subTest(told.name):
                for mark in told.microscope["marks"]:
                    self.check_mark(mark, answers[mark["name"]], told.exact, told.length)
                    marks += 1
        self.assertGreater(marks, 400)

    def check_mark(self, mark, method, exact, length):
        ulp = ulp_of(float(exact["s"]))
        if mark["kind"] == "s":
            self.assert_close(mark["x"], (Decimal(float.fromhex(method["s"])) - exact["s"]) / ulp)
            self.assertEqual(mark["y"], "0")
            return
        point = next(step for step in method["steps"] if step["symbol"] == "Q")["value"]
        offset = (Vector(map(float.fromhex, point)) - exact["Q"]) / (ulp * length)
        self.assert_close(mark["x"], offset.dot_product(exact["D"]))
        to_centre = exact["T"] - exact["v"] * exact["D"]
        if to_centre.norm() > NO_SIDE:
            self.assert_close(mark["y"], offset.dot_product(to_centre / to_centre.norm()))

    def assert_close(self, told, exact):
        """A number of the microscope, which is a JSON number."""
        is_close = abs(Decimal(told) - exact) <= max(NOTHING, CLOSE * abs(exact))
        self.assertTrue(is_close, f"{told}, exactly {float(exact)}")


if __name__ == "__main__":
    pages.main("--disable-3d-apis")
