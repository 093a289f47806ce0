"""The steps from a camera or a ray to its hit, in decimals with enough digits that every double is exact and cancellation
does not matter."""
import decimal
import math
from decimal import Decimal

DIGITS = 2600  # squares of lengths from 2^-1074 to 2^1023 in one sum
decimal.setcontext(decimal.Context(prec=DIGITS, Emax=decimal.MAX_EMAX, Emin=decimal.MIN_EMIN))


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


def ulp_of(value):
    """The gap between the doubles above the size of a double."""
    return Decimal(math.nextafter(abs(value), math.inf)) - Decimal(abs(value))


def unit(vector):
    return vector / vector.norm()


def ray_of(camera, i, j):
    """P of a pixel, and the direction to it: rows from the bottom, samples at the edges, rays from the image plane."""
    eye, look_at, up = (Vector(camera[name]) for name in ("eye", "look_at", "up"))
    W = unit(eye - look_at)
    U = unit(up.cross_product(W))
    near, left, right, bottom, top = (Decimal(camera[name]) for name in ("near", "left", "right", "bottom", "top"))
    alpha = left + (right - left) * i / (camera["width"] - 1)
    beta = bottom + (top - bottom) * j / (camera["height"] - 1)
    P = eye + near * W + alpha * U + beta * W.cross_product(U)
    return P, unit(P - eye)


def derivation(origin, direction, sphere, is_hit):
    """The steps of docs/problem.md by their symbols: each a Decimal or a Vector. The first s >= 0 is the answer."""
    centre, radius = Vector(sphere[0]), Decimal(sphere[1])
    D = unit(direction)
    T = centre - origin
    v = T.dot_product(D)
    steps = {"D": D, "T": T, "v": v, "d^2": radius * radius - (T.dot_product(T) - v * v)}
    if is_hit:
        d = max(steps["d^2"], Decimal(0)).sqrt()
        along = v - d if v - d >= 0 else v + d
        steps |= {"s": along / direction.norm(), "Q": origin + along * D}
    return steps
