"""Decides rays and spheres only by integers, as an oracle for python_oracle_test.cpp.

Each line of standard input: ten hexfloats (origin, direction, centre, radius), t_min, t_max, the
ends ("[]", "[)", "(]", "()"), "absolute" or "radius", the culling and the root convention. Each line
of output: miss, or tangent or hit, near or far, and the doubles nearest to both roots of
|o + t d - C|^2 = r^2 (ties to even), as hexfloats.
"""

import math
import struct
import sys
from fractions import Fraction

ONE = 1 << 1075  # Every double, and every midpoint of two, is a multiple of 1/ONE.


def scaled(bits):
    """ONE times the nonnegative double of this bit pattern; beyond the largest comes 2^1024."""
    if bits == 0x7FF << 52:
        return 1 << (1024 + 1075)
    return int(Fraction(struct.unpack("<d", struct.pack("<Q", bits))[0]) * ONE)


def sign_at(t, a, b, c, larger):
    """The sign of t / ONE - root, of the roots of a x^2 - 2 b x + c."""
    value = a * t * t - 2 * b * t * ONE + c * ONE * ONE
    side = a * t - b * ONE
    if larger:
        return (value > 0) - (value < 0) if side >= 0 else -1
    return (value < 0) - (value > 0) if side <= 0 else 1


def nearest_double(a, b, c, larger):
    """The double nearest to a root, found by halving the bit patterns of the doubles."""
    if sign_at(0, a, b, c, larger) > 0:  # The root is negative: take the other equation's.
        return -nearest_double(a, -b, c, not larger)
    low, high = 0, 0x7FF << 52
    if sign_at(scaled(high), a, b, c, larger) < 0:
        return math.inf
    while high - low > 1:
        middle = (low + high) // 2
        if sign_at(scaled(middle), a, b, c, larger) <= 0:
            low = middle
        else:
            high = middle
    side = sign_at((scaled(low) + scaled(high)) // 2, a, b, c, larger)
    bits = high if side < 0 or (side == 0 and low % 2 == 1) else low
    return struct.unpack("<d", struct.pack("<Q", bits))[0]


for line in sys.stdin:
    words = line.split()
    numbers = [Fraction(float.fromhex(word)) for word in words[:10]]
    scale = math.lcm(*(x.denominator for x in numbers))
    ox, oy, oz, dx, dy, dz, cx, cy, cz, r = (int(x * scale) for x in numbers)
    fx, fy, fz = cx - ox, cy - oy, cz - oz
    a = dx * dx + dy * dy + dz * dz
    b = fx * dx + fy * dy + fz * dz
    c = fx * fx + fy * fy + fz * fz - r * r
    discriminant = b * b - a * c
    low, high = (float.fromhex(word) for word in words[10:12])
    ends, unit, culling, convention = words[12:]

    def beyond(t, larger):
        """The sign of t - root."""
        if t == math.inf:
            return 1
        t = Fraction(t) * (numbers[9] if unit == "radius" else 1)
        side = t * a - b
        value = side * t - b * t + c
        if larger:
            return (value > 0) - (value < 0) if side >= 0 else -1
        return (value < 0) - (value > 0) if side <= 0 else 1

    def counts(larger):
        first, last = beyond(low, larger), beyond(high, larger)
        above = first < 0 or (first == 0 and ends[0] == "[")
        return above and (last > 0 or (last == 0 and ends[1] == "]"))

    allowed = [("near", False)] if culling != "front-faces" else []
    if culling != "back-faces" and convention != "smaller":
        allowed.append(("far", True))
    found = [name for name, larger in allowed if counts(larger)] if discriminant >= 0 else []
    if not found:
        print("miss")
        continue
    roots = (nearest_double(a, b, c, larger).hex() for larger in (False, True))
    print("tangent" if discriminant == 0 else "hit", found[0], *roots)
