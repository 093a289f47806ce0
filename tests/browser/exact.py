"""A ray and a sphere in decimals of so many digits that every double is exact and nothing that matters cancels.

Independent of raycheck: the camera and the roots as docs/problem.md states them. Also an evaluator of the Sage input
that a page offers, for sessions without Sage.
"""
import dataclasses
import decimal
import math
import re
from decimal import Decimal

DIGITS = 2600  # squares of lengths from 2^-1074 to 2^1023 in one sum
decimal.setcontext(decimal.Context(prec=DIGITS, Emax=decimal.MAX_EMAX, Emin=decimal.MIN_EMIN))
NOTHING = Decimal(10) ** -(DIGITS // 2)  # relative: what rounding leaves of an exact zero


class Vector(tuple):
    def __new__(cls, values):
        return super().__new__(cls, map(Decimal, values))

    def __add__(self, other):
        return Vector(a + b for a, b in zip(self, other))

    def __sub__(self, other):
        return Vector(a - b for a, b in zip(self, other))

    def __mul__(self, factor):
        return Vector(a * factor for a in self)

    __rmul__ = __mul__

    def __truediv__(self, divisor):
        return Vector(a / divisor for a in self)

    def dot_product(self, other):
        return sum(a * b for a, b in zip(self, other))

    def cross_product(self, other):
        (a, b, c), (x, y, z) = self, other
        return Vector([b * z - c * y, c * x - a * z, a * y - b * x])

    def norm(self):
        return self.dot_product(self).sqrt()


@dataclasses.dataclass
class Line:
    """Points origin + s length direction, direction of length 1."""
    origin: Vector
    direction: Vector
    length: Decimal

    def at(self, s):
        return self.origin + s * self.length * self.direction


def given_ray(origin, direction):
    direction = Vector(direction)
    return Line(Vector(origin), direction / direction.norm(), direction.norm())


def pixel_ray(camera, i, j):
    """Under the default conventions: rows bottom-first, samples at the edges, origin at the pixel."""
    eye, look_at, up = (Vector(camera[name]) for name in ("eye", "look_at", "up"))
    near, left, right, bottom, top = (Decimal(camera[name]) for name in ("near", "left", "right", "bottom", "top"))
    W = (eye - look_at) / (eye - look_at).norm()
    U = up.cross_product(W)
    U = U / U.norm()
    V = W.cross_product(U)
    alpha = left + Decimal(i) / (camera["width"] - 1) * (right - left)
    beta = bottom + Decimal(j) / (camera["height"] - 1) * (top - bottom)
    P = eye + near * W + alpha * U + beta * V
    return Line(P, (P - eye) / (P - eye).norm(), Decimal(1))


def nearest_root(line, centre, radius):
    """The smallest s >= 0, or None. What is left of an exact zero by rounding is one."""
    T = Vector(centre) - line.origin
    v = T.dot_product(line.direction)
    across = T - v * line.direction
    squares = Decimal(radius) ** 2 + across.dot_product(across)
    d_squared = Decimal(radius) ** 2 - across.dot_product(across)
    if abs(d_squared) <= NOTHING * squares:
        d_squared = Decimal(0)
    if d_squared < 0:
        return None
    d = d_squared.sqrt()
    least = -NOTHING * (abs(v) + d)
    return next((max(root, Decimal(0)) / line.length for root in (v - d, v + d) if root >= least), None)


def ulp_of(value):
    """The gap between the doubles above the size of a double."""
    return Decimal(math.nextafter(abs(value), math.inf)) - Decimal(abs(value))


def evaluated_sage(text):
    """The values that Sage input shows, a list, each a Decimal or a Vector."""
    python = re.sub(r"\b\d+\b", lambda match: f"Decimal({match[0]})", text.replace("^", "**"))
    shown = []
    names = {"vector": Vector, "Decimal": Decimal, "sqrt": lambda x: x.sqrt(), "show": shown.extend, "__builtins__": {}}
    exec(python, names)  # of raycheck's own making, and without any builtin
    return shown
