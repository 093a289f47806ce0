"""Decides which roots count, by fractions alone, as an oracle for python_roots_test.cpp.

Each line of standard input: ten hexfloats (origin, direction, centre, radius), t_min, t_max, the
ends ("[]", "[)", "(]", "()"), "absolute" or "radius", the culling and the root convention. Each line
of output: miss, or tangent or hit and near or far.
"""

import sys
from fractions import Fraction


def side(a, b, disc, which, t):
    """The sign of (b + which sqrt(disc)) / a - t."""
    rest = b - t * a
    if which == 0 or disc == 0:
        return (rest > 0) - (rest < 0)
    if rest * which >= 0:
        return which
    difference = disc - rest * rest
    return which * ((difference > 0) - (difference < 0))


for line in sys.stdin:
    words = line.split()
    o, d, c = ([Fraction(float.fromhex(x)) for x in words[k : k + 3]] for k in (0, 3, 6))
    r = Fraction(float.fromhex(words[9]))
    unit = r if words[13] == "radius" else 1
    low = Fraction(float.fromhex(words[10])) * unit
    high = None if words[11] == "inf" else Fraction(float.fromhex(words[11])) * unit
    ends, culling, convention = words[12], words[14], words[15]
    t = [x - y for x, y in zip(c, o)]
    a = sum(x * x for x in d)
    b = sum(x * y for x, y in zip(t, d))
    disc = b * b - a * (sum(x * x for x in t) - r * r)

    def counts(which):
        above = side(a, b, disc, which, low)
        if above < 0 or (above == 0 and ends[0] == "("):
            return False
        if high is None:
            return True
        beyond = side(a, b, disc, which, high)
        return beyond < 0 or (beyond == 0 and ends[1] == "]")

    allowed = [("near", -1)] if culling != "front-faces" else []
    if culling != "back-faces" and convention != "smaller":
        allowed.append(("far", 1))
    found = [name for name, which in allowed if counts(which)] if disc >= 0 else []
    if not found:
        print("miss")
    else:
        print("tangent" if disc == 0 else "hit", found[0])
