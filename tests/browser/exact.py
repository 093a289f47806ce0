"""An evaluator of the Sage input that a page offers, for sessions without Sage: in decimals of so many digits that every
double is exact and nothing that matters cancels."""
import decimal
import math
import re
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


def evaluated_sage(text):
    """The values that Sage input shows, a list, each a Decimal or a Vector."""
    python = re.sub(r"\b\d+\b", lambda match: f"Decimal({match[0]})", text.replace("^", "**"))
    shown = []
    names = {"vector": Vector, "Decimal": Decimal, "sqrt": lambda x: x.sqrt(), "show": shown.extend, "__builtins__": {}}
    exec(python, names)  # of raycheck's own making, and without any builtin
    return shown
