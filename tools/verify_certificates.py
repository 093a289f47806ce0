#!/usr/bin/env python3
"""Confirms the certificates of raycheck without raycheck, by rational numbers alone.

usage: verify_certificates.py FILE...          (docs/certificates.md describes the format)

Everything is recomputed from the integers of the inputs; what a certificate states is only compared
with it. Ends with 0 when nothing is refuted, with 1 when something is, with 2 on a file that cannot
be read.
"""

import json
import sys
from fractions import Fraction

U = Fraction(1, 2**53)  # the unit of relative errors
NARROW = Fraction(1, 2**60)  # brackets are no wider, relative to what they bracket
TOLERANCE = Fraction(1, 1000)  # of a stated error: it is an upper bound, and printed to 3 digits
INFINITE = Fraction(2) ** 2046  # the square of an error that counts as infinite
SOME_SPHERE = "a sphere"  # what a picture shows that does not tell which
CONVENTIONS = {
    "rows": ("bottom-first", "top-first"),
    "samples": ("edges", "centres"),
    "origin": ("pixel", "focal"),
    "root": ("nearest", "smaller"),
    "tangent": ("hit", "miss", "either"),
}


class Refuted(Exception):
    """What a certificate says is not so, or its brackets do not show it."""


def require(fact, what):
    if not fact:
        raise Refuted(what)


def number(pair):
    """[integer, exponent] is integer * 2^exponent; an integer beyond 2^53 is a string."""
    return int(pair[0]) * Fraction(2) ** pair[1]


def numbers(pairs):
    return [number(pair) for pair in pairs]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def times(x, v):
    return [x * y for y in v]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm_sq(v):
    return sum(x**2 for x in v)


# A ray and a sphere: start + mu g, mu >= 0, on the line base + mu g. Of a given ray every number is
# a Fraction and these three functions are the whole proof; of a camera's ray some are Intervals.


def equation(ray, centre, radius):
    """The a, b, c of a mu^2 - 2 b mu + c = 0, whose roots are on the sphere; and b^2 - a c."""
    T, moment = minus(centre, ray.start), cross(minus(centre, ray.base), ray.g)
    c, discriminant = dot(T, T) - radius**2, ray.a * radius**2 - dot(moment, moment)
    return ray.a, dot(T, ray.g), c, discriminant


def root_met(b, c, discriminant, conventions):
    """Which root the ray meets: the "smaller", the "larger", or None for a miss."""
    larger = "larger" if conventions["root"] == "nearest" else None
    if discriminant < 0 or (not discriminant > 0 and conventions["tangent"] == "miss"):
        return None
    if c < 0:  # inside: one root on each side of the start
        return larger
    if c > 0:  # outside: both roots on the side that b says
        return "smaller" if b > 0 else None
    return "smaller" if not b < 0 else larger  # on the sphere: one root is 0


def is_root_between(low, high, root, a, b, c):
    """p(mu) >= 0 and b - a mu >= 0 hold up to the smaller root, and nowhere else."""
    if root == "larger":  # it is minus the smaller root of p(-mu)
        low, high, b = -high, -low, -b
    p = lambda mu: a * mu * mu - 2 * b * mu + c
    not_above = not b - a * low < 0 and not p(low) < 0
    not_below = not b - a * high > 0 or not p(high) > 0
    return not_above and not_below


# A camera's ray: three square roots, each between two dyadic numbers that the certificate gives.


class Interval:
    """Every number from low to high. Arithmetic holds every result; comparisons must be certain."""

    def __init__(self, low, high):
        self.low, self.high = low, high

    def __neg__(self):
        return Interval(-self.high, -self.low)

    def __add__(self, other):
        low, high = ends(other)
        return Interval(self.low + low, self.high + high)

    def __mul__(self, other):
        if not isinstance(other, Interval):
            low, high = self.low * other, self.high * other
            return Interval(low, high) if other >= 0 else Interval(high, low)
        products = [x * y for x in (self.low, self.high) for y in (other.low, other.high)]
        return Interval(min(products), max(products))

    def inverse(self):
        require(self.low > 0 or self.high < 0, "a divisor may be 0")
        return Interval(1 / Fraction(self.high), 1 / Fraction(self.low))

    def __truediv__(self, other):
        if isinstance(other, Interval):
            return self * other.inverse()
        require(other != 0, "a divisor may be 0")
        return self * (1 / Fraction(other))

    def __rtruediv__(self, other):
        return self.inverse() * other

    def __pow__(self, two):
        squares = (self.low**2, self.high**2)
        holds_0 = self.low <= 0 <= self.high
        return Interval(Fraction(0) if holds_0 else min(squares), max(squares))

    def __gt__(self, other):
        low, high = ends(other)
        require(self.low > high or self.high <= low, "the brackets are too wide to decide a sign")
        return self.low > high

    def __lt__(self, other):
        return -self > -other

    __radd__ = __add__
    __rmul__ = __mul__

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other


def ends(x):
    return (x.low, x.high) if isinstance(x, Interval) else (x, x)


def stated_ends(bracket):
    """[low, high, exponent]: from low * 2^exponent to high * 2^exponent."""
    low, high, exponent = bracket
    return number([low, exponent]), number([high, exponent])


def bracket(stated):
    """A bracket narrow enough to speak of one number: an Interval, or that number."""
    low, high = stated_ends(stated)
    require(low <= high, "a bracket's ends are exchanged")
    require(high - low <= NARROW * max(abs(low), abs(high)), "a bracket is too wide")
    return low if low == high else Interval(low, high)


def square_root(stated, square):
    """A bracket of the square root of a nonnegative number."""
    low, high = ends(bracket(stated))
    require(0 <= low and low**2 <= square <= high**2, "a square root is not in its bracket")
    return low if low == high else Interval(low, high)


class Ray:
    def __init__(self, base, start, g, a, unit, is_given):
        self.base, self.start, self.g, self.a = base, start, g, a
        self.unit = unit  # s = unit * mu
        self.is_given = is_given


def given_ray(stated):
    origin, g = numbers(stated["origin"]), numbers(stated["direction"])
    return Ray(origin, origin, g, dot(g, g), Fraction(1), is_given=True)


def camera_axes(camera, roots):
    w = minus(numbers(camera["eye"]), numbers(camera["look_at"]))
    u = cross(numbers(camera["up"]), w)
    w_length = square_root(roots["|E - A|"], dot(w, w))
    u_length = square_root(roots["|up x (E - A)|"], dot(u, u))
    W, U = [x / w_length for x in w], [x / u_length for x in u]
    return U, cross(W, U), W


def position(low, high, index, count, conventions):
    edges = conventions["samples"] == "edges"
    share = Fraction(index, count - 1) if edges else Fraction(2 * index + 1, 2 * count)
    return number(low) + share * (number(high) - number(low))


def camera_ray(camera, pixel, conventions, roots):
    """n W + alpha U + beta V, from E or from P. Its square is n^2 + alpha^2 + beta^2."""
    (U, V, W), (i, row) = camera_axes(camera, roots), pixel
    if conventions["rows"] == "top-first":
        row = camera["height"] - 1 - row
    n = number(camera["near"])
    alpha = position(camera["left"], camera["right"], i, camera["width"], conventions)
    beta = position(camera["bottom"], camera["top"], row, camera["height"], conventions)
    g = plus(plus(times(n, W), times(alpha, U)), times(beta, V))
    a = n**2 + alpha**2 + beta**2
    eye = numbers(camera["eye"])
    start = plus(eye, g) if conventions["origin"] == "pixel" else eye
    return Ray(eye, start, g, a, square_root(roots["|P - E|"], a), is_given=False)


# What a certificate states, against what was computed.


class Meeting:
    """How a ray meets a sphere, recomputed and compared with what is stated of it."""

    def __init__(self, ray, sphere, stated, conventions):
        self.ray, self.radius = ray, number(sphere["radius"])
        self.centre = numbers(sphere["centre"])
        a, b, c, discriminant = equation(ray, self.centre, self.radius)
        require(a > 0 and self.radius >= 0, "the ray has no direction, or the radius is negative")
        for name, x in (("discriminant", discriminant), ("c", c), ("b", b)):
            if name in stated:
                (low, high), (x_low, x_high) = stated_ends(stated[name]), ends(x)
                width = 0 if ray.is_given else NARROW * max(abs(low), abs(high))
                is_stated = low <= x_low and x_high <= high and high - low <= width
                require(is_stated, f"{name} is not the one stated")
        self.root = root_met(b, c, discriminant, conventions)
        require(self.root == stated["root"], "the root that is met is not the one stated")
        other = {"smaller": "larger", "larger": "smaller", None: None}[self.root]
        self.s = self.bracket(stated.get("s"), self.root, a, b, c)
        self.other_s = self.bracket(stated.get("other_s"), other, a, b, c)

    def bracket(self, stated, root, a, b, c):
        if root is None or stated is None:
            return None
        s = bracket(stated)
        low, high = (end / self.ray.unit for end in ends(s))
        require(is_root_between(low, high, root, a, b, c), f"the {root} root is not in its bracket")
        return s

    def point(self):
        return plus(self.ray.start, times(self.s / self.ray.unit, self.ray.g))


def rounded(x):
    try:
        return float(x)
    except OverflowError:
        return float("inf") if x > 0 else float("-inf")


def require_exact(stated, computed):
    """The stated doubles are the computed numbers, rounded to nearest."""
    require(len(stated) == len(computed), "there are more or fewer exact values than stated")
    size = max((abs(end) for x in computed for end in ends(x)), default=0)
    for double, x in zip(stated, computed):
        low, high = ends(x)
        require(high - low <= NARROW * size, "the brackets are too wide for the exact value")
        value = float(double) if isinstance(double, str) else rounded(number(double))
        require(rounded(low) <= value <= rounded(high), "the exact value is not the one stated")


def require_error(stated, squares):
    """The stated error is, to the tolerance, the square root of one of the computed squares."""
    for low, high in map(ends, squares):
        if stated == "infinity":
            if low >= INFINITE:
                return
            continue
        error = Fraction(stated)
        slack = TOLERANCE * max(error, 1)
        if (error <= slack or (error - slack) ** 2 <= low) and high <= (error + slack) ** 2:
            return
    raise Refuted("the error is not the one stated")


def relative_sq(gap_sq, size_sq):
    """The square of a relative error in units of u; of a true value 0, all or nothing."""
    if ends(size_sq)[1] == 0:
        return 0 if ends(gap_sq)[1] == 0 else INFINITE
    return gap_sq / size_sq / U**2


def ulps_sq(got, s):
    """The square of an error in ulp; at a power of two, where two gaps meet, in either."""

    def ulp(x):  # The denominator is a power of two.
        exponent = abs(x.numerator).bit_length() - x.denominator.bit_length() + 1
        return Fraction(2) ** max(exponent - 53, -1074)

    if ends(s) == (0, 0):
        return [relative_sq(got**2, s)]
    return [((got - s) / ulp(end)) ** 2 for end in ends(s)]


def angle_sq(got, g):
    """The square of the angle's tangent in units of u."""
    cosine = dot(got, g)
    return norm_sq(cross(got, g)) / cosine**2 / U**2 if cosine > 0 else INFINITE


def backward_sq(s, ray, met):
    """The square of the relative change of the inputs that makes s a root, in units of u."""
    way = times(s, ray.g)
    off = minus(plus(ray.start, way), met.centre)
    sizes = [sum(map(abs, parts)) for parts in zip(ray.start, met.centre, way)]
    scale = 2 * dot(list(map(abs, off)), sizes) + 2 * met.radius**2
    return relative_sq((norm_sq(off) - met.radius**2) ** 2, scale**2)


def orthonormality_sq(axes, norms):
    """The square of the largest defect of length and of mutual cosines."""
    if not dot(cross(axes[0], axes[1]), axes[2]) > 0:
        return INFINITE
    defects = [square_root(norm, norm_sq(axis)) - 1 for norm, axis in zip(norms, axes)]
    defects += [dot(axes[k], axes[(k + 1) % 3]) for k in range(3)]
    lows, highs = zip(*(ends((defect / U) ** 2) for defect in defects))
    return Interval(max(lows), max(highs))


def measured(certificate, ray, meetings, got):
    """The exact value, and a function that gives the square of the error of what was got."""
    quantity, proof = certificate["quantity"], certificate["proof"]
    if quantity == "orthonormality":
        return [], lambda: [orthonormality_sq([got[0:3], got[3:6], got[6:9]], proof["norms"])]
    if quantity == "frame":
        axes = camera_axes(certificate["inputs"]["camera"], proof["roots"])
        exact = dict(zip("UVW", axes))[certificate["what"]]
    elif quantity == "pixel point":
        exact = plus(ray.base, ray.g)
    elif quantity == "ray origin":
        exact = ray.start
    elif quantity in ("direction", "unit defect"):
        exact = [x / ray.unit for x in ray.g]
        if quantity == "direction":
            return exact, lambda: [angle_sq(got, ray.g)]
        return exact, lambda: [((square_root(proof["norms"][0], norm_sq(got)) - 1) / U) ** 2]
    else:
        (met,) = meetings
        require(met.root, "the sphere is not met")
        exact = met.point()
    if quantity == "parameter":
        return [met.s], lambda: ulps_sq(got[0], met.s)
    if quantity == "backward error":
        return [], lambda: [backward_sq(got[0], ray, met)]
    if quantity == "sphere residual":
        distance = lambda: square_root(proof["norms"][0], norm_sq(minus(got, met.centre)))
        return [], lambda: [relative_sq((distance() - met.radius) ** 2, met.radius**2)]
    if quantity == "ray residual":
        along = lambda: minus(got, ray.start)
        return [], lambda: [relative_sq(norm_sq(cross(along(), ray.g)), norm_sq(along()) * ray.a)]
    return exact, lambda: [relative_sq(norm_sq(minus(got, exact)), norm_sq(exact))]


def confirm_met(certificate, met, got):
    """class, root: what is right or wrong."""
    wrong, answered = certificate["wrong"], bool(certificate["got"])
    require_exact(certificate["exact"], [met.s] if met.root else [])
    if certificate["quantity"] == "class":
        stated = {"missed": (True, False), "false hit": (False, True)}[wrong]
        require((bool(met.root), answered) == stated, f"it is no {wrong}")
        return
    require(wrong == "wrong root" and met.root, "there is no root to miss")
    gap_sq, apart_sq = (got[0] - met.other_s) ** 2, (met.s - met.other_s) ** 2
    require(16 * gap_sq < apart_sq, "the answer is not at the other root")


def confirm_nearest(certificate, meetings):
    exact = [int(x) for x in numbers(certificate["exact"])]
    # A picture may show a sphere without telling which: that is right wherever one is met.
    is_untold = certificate["got"] == [SOME_SPHERE]
    got = [] if is_untold else [int(x) for x in numbers(certificate["got"])]
    require(not (exact and is_untold), "a sphere is met, and a sphere was said")
    require(exact or got or is_untold, "nothing is met, and nothing was said")
    wrong = {(1, 1): "wrong sphere", (1, 0): "missed", (0, 1): "false hit",
             (0, 0): "false hit"}[len(exact), len(got)]
    require(wrong == certificate["wrong"], "it is wrong in another way")
    if not exact:
        require(not any(met.root for met in meetings), "a sphere is met")
        return
    require(all(k in range(len(meetings)) for k in exact + got), "there is no such sphere")
    first = meetings[exact[0]]
    require(first.root, "the sphere is not met")
    for k, met in enumerate(meetings):
        same = met.centre == first.centre and met.radius == first.radius
        if met.root and (k in got or not same):
            low, high = ends(met.s)[0], ends(first.s)[1]
            require(low > high if k in got else low >= high, "another sphere is met before")


def confirm(certificate):
    """Raises Refuted unless the certificate's inputs prove what it states."""
    inputs, proof = certificate["inputs"], certificate["proof"]
    conventions, quantity = certificate["conventions"], certificate["quantity"]
    for name, values in CONVENTIONS.items():
        require(conventions[name] in values, f"there is no such convention of {name}")
    require(certificate["pixel"] == inputs.get("pixel"), "the pixel is another")
    ray = None
    if "ray" in inputs:
        ray = given_ray(inputs["ray"])
    elif "pixel" in inputs:
        ray = camera_ray(inputs["camera"], inputs["pixel"], conventions, proof["roots"])
    spheres, stated = inputs.get("spheres", []), proof.get("spheres", [])
    require(len(spheres) == len(stated), "a sphere's proof is missing")
    meetings = [Meeting(ray, *each, conventions) for each in zip(spheres, stated)]
    if quantity == "nearest sphere":
        return confirm_nearest(certificate, meetings)
    is_finite = not any(isinstance(x, str) for x in certificate["got"])
    got = numbers(certificate["got"]) if is_finite else None
    if quantity in ("class", "root"):
        (met,) = meetings
        confirm_met(certificate, met, got)
    else:
        require(certificate["wrong"] is None, "an error is measured, not a decision")
        unit = "ulp" if quantity == "parameter" else "u"
        require(certificate["unit"] == unit, "the unit is another")
        exact, squares = measured(certificate, ray, meetings, got)
        require_exact(certificate["exact"], exact)
        require_error(certificate["error"], squares() if is_finite else [INFINITE])


def title(certificate):
    pixel, ray, sphere = (certificate[key] for key in ("pixel", "ray", "sphere"))
    parts = [f"{certificate['method']}: {certificate['quantity']}"]
    if pixel is not None:
        parts.append(f"pixel ({pixel[0]}, {pixel[1]})")
    elif ray is not None:
        parts.append(f"ray {ray}")
    parts += [] if sphere is None else [f"sphere {sphere}"]
    parts += [certificate["what"]] if certificate["what"] else []
    error = f"off by {float(certificate['error']):.3g} {certificate['unit']}"
    return ", ".join(parts) + ": " + (certificate["wrong"] or error)


def judge(certificate):
    """What becomes of a certificate, and why."""
    if not certificate["certified"]:
        return "not certified", certificate["reason"]
    try:
        confirm(certificate)
    except Refuted as reason:
        return "REFUTED", str(reason)
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        return "REFUTED", f"malformed: {error!r}"
    return "confirmed", ""


def main(paths):
    counts = {"confirmed": 0, "REFUTED": 0, "not certified": 0}
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for certificate in map(json.loads, file):
                state, why = judge(certificate)
                counts[state] += 1
                print(f"{state}  {title(certificate)}" + (f": {why}" if why else ""))
    print(", ".join(f"{count} {state.lower()}" for state, count in counts.items()))
    return 1 if counts["REFUTED"] else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    try:
        sys.exit(main(sys.argv[1:]))
    except (OSError, ValueError, KeyError) as problem:
        print(f"verify_certificates.py: {problem!r}", file=sys.stderr)
        sys.exit(2)
