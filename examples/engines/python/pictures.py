"""Shared by the adapters of renderers: the scene that raycheck gives."""
import math
import sys
import typing


class Scene(typing.NamedTuple):
    """U, V and W are the camera's unit axes, W from the look-at point to the eye; the picture is in the plane at eye + near W.
    left, right, bottom and top are the edges of the picture there, half a pixel outside the first and last pixels' centres.
    A sphere has x, y, z, radius, red, green and blue."""
    eye: list
    U: list
    V: list
    W: list
    near: float
    left: float
    right: float
    bottom: float
    top: float
    width: int
    height: int
    spheres: list


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def unit(p):
    length = sum(x * x for x in p) ** 0.5
    return [x / length for x in p]


def combined(*terms):
    """The sum of factors times vectors, each given as (factor, vector)."""
    return [sum(factor * vector[k] for factor, vector in terms) for k in range(3)]


def words(numbers, between=" "):
    return between.join(f"{x:.17g}" for x in numbers)


def read(path):
    """The scene of a driver file, or of an NFF file, whose camera has one angle and square pixels."""
    view, spheres, colour = {}, [], None
    for line in open(path):
        name, *rest = line.split("#")[0].split() or [""]
        numbers = [float(word) for word in rest]
        if name == "f":
            colour = numbers[:3]
        elif name in ("s", "sphere"):
            spheres.append(numbers + colour if name == "s" else numbers[:7])
        elif name:
            view[name] = numbers
    is_nff = "from" in view
    eye = view["from" if is_nff else "eye"]
    W = unit(combined((1, eye), (-1, view["at" if is_nff else "look"])))
    U = unit(cross(view["up"], W))
    width, height = map(int, view["resolution" if is_nff else "res"])
    if is_nff:
        near, top = -1, math.tan(math.radians(view["angle"][0]) / 2)
        left, right, bottom = -top * width / height, top * width / height, -top
    else:
        # The bounds are those of the first and last pixels' centres; raycheck gives pictures of two pixels or more each way.
        (near,), (left, right, bottom, top) = view["d"], view["bounds"]
        x, y = (right - left) / (2 * (width - 1)), (top - bottom) / (2 * (height - 1))
        left, right, bottom, top = left - x, right + x, bottom - y, top + y
    return Scene(eye, U, cross(W, U), W, near, left, right, bottom, top, width, height, spheres)


def leave_out_from_inside(scene):
    """Ends the adapter of a renderer that does not show the insides of spheres, if the eye is in one, or nearly."""
    if any(math.dist(scene.eye, sphere[:3]) - sphere[3] < 0.01 for sphere in scene.spheres):
        sys.exit(77)
