"""Shared by the adapters of renderers: the scene that raycheck gives, and PPM files."""
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


def cannot_express():
    """Ends an adapter whose renderer has no such camera or sphere."""
    sys.exit(77)


def read(driver):
    view, spheres = {}, []
    for line in open(driver):
        name, *rest = line.split("#")[0].split() or [""]
        if name == "sphere":
            spheres.append([float(word) for word in rest[:7]])
        elif name:
            view[name] = [float(word) for word in rest]
    W = unit(combined((1, view["eye"]), (-1, view["look"])))
    U = unit(cross(view["up"], W))
    left, right, bottom, top = view["bounds"]
    width, height = map(int, view["res"])
    # The bounds are those of the first and last pixels' centres; raycheck gives pictures of two pixels or more each way.
    x, y = (right - left) / (2 * (width - 1)), (top - bottom) / (2 * (height - 1))
    return Scene(view["eye"], U, cross(W, U), W, view["d"][0], left - x, right + x, bottom - y, top + y, width, height, spheres)


def write_ppm(path, width, height, pixel):
    """Writes a picture; pixel(i, j) is the colour, three numbers from 0 to 1, of column i in row j from the top."""
    with open(path, "wb") as file:
        file.write(b"P6 %d %d 255\n" % (width, height))
        file.write(bytes(round(255 * channel) for j in range(height) for i in range(width) for channel in pixel(i, j)))
