#!/usr/bin/env python3
"""Checks the certificates of raycheck without raycheck, using only rational numbers.

usage: verify_certificates.py FILE...          (docs/certificates.md describes the format)

Everything is recomputed from the integers of the inputs, and compared with the statements of the
certificate. Exit code: 0 if all are confirmed or not certified, 1 if one is refuted, 2 if a file
cannot be read or at its first line that is not a certificate.
"""

import json
import sys
from fractions import Fraction
from math import isqrt

U = Fraction(1, 2**53)  # the unit of relative errors of doubles; floats have another
FORMATS = {"double": (53, -1074), "single": (24, -149)}  # digits, and the least exponent
NARROW = Fraction(1, 2**60)  # the largest relative width of brackets
TOLERANCE = Fraction(1, 1000)  # on a stated error, which is an upper bound, printed to 3 digits
ROOT_BITS = (320, 5000)  # of square roots on changed inputs: the second if the first do not decide
MOST_SECTORS = 256  # of a plane, examined one by one
INFINITE = Fraction(2) ** 2046  # the square of an error that counts as infinite
SOME_SPHERE = "a sphere"  # the answer of a picture that does not show which sphere it is
CONVENTIONS = {
    "rows": ("bottom-first", "top-first"),
    "samples": ("edges", "centres", "corners"),
    "origin": ("pixel", "focal"),
    "root": ("nearest", "smaller"),
    "tangent": ("hit", "miss", "either"),
}


class Refuted(Exception):
    """A statement of a certificate is false, or its brackets do not prove it."""


class Undecided(Refuted):
    """Brackets are too wide to decide a statement."""


def require(fact, what):
    if not fact:
        raise Refuted(what)


class Malformed(Exception):
    """A line is not a certificate."""


# The required form of a line, checked before any computation. Each shape is a function of a value
# and its location that may raise Malformed. Keys that no shape names are ignored.

LONGEST = 4000  # digits: products of four doubles have fewer
EXPONENTS = range(-1074, 1024)  # of doubles
BRACKET_EXPONENTS = range(-(2**14), 2**14)  # products of four doubles, and roots, to more bits
PLAIN_DIGITS = 19  # of integers that are not strings: 64 bits, as for pixels
WORDS = ("nan", "inf", "-inf", SOME_SPHERE)  # allowed instead of a number


def leaf(holds, what):
    def shape(value, where):
        if not holds(value):
            raise Malformed(f"{where} is not {what}")

    return shape


def or_null(inner):
    return lambda value, where: value is None or inner(value, where)


def every(inner, count=None):
    def shape(value, where):
        if not isinstance(value, list) or count not in (None, len(value)):
            raise Malformed(f"{where} is not a list" + ("" if count is None else f" of {count}"))
        for k, each in enumerate(value):
            inner(each, f"{where}[{k}]")

    return shape


def fields(required, optional={}):
    def shape(value, where):
        if not isinstance(value, dict):
            raise Malformed(f"{where} is not an object")
        for name, inner in {**required, **optional}.items():
            if name in value:
                inner(value[name], f"{where}.{name}")
            elif name in required:
                raise Malformed(f"{where}.{name} is missing")

    return shape


def is_integer(x):
    digits = x[x.startswith("-") :] if isinstance(x, str) else ""
    of_digits = digits.isascii() and digits.isdecimal() and len(digits) <= LONGEST
    return type(x) is int or of_digits


def is_double(x):
    is_pair = isinstance(x, list) and len(x) == 2 and all(type(each) is int for each in x)
    return is_pair and x[1] in EXPONENTS


def is_bracket(x):
    is_triple = isinstance(x, list) and len(x) == 3 and all(map(is_integer, x))
    return is_triple and type(x[2]) is int and x[2] in BRACKET_EXPONENTS


def is_share(x):
    try:
        return abs(float.fromhex(x)) < float("inf")
    except (TypeError, ValueError, OverflowError):
        return False


def is_amount(x):
    return type(x) in (int, float) and 0 <= x < float("inf")


text = leaf(lambda x: isinstance(x, str), "a text")
whole = leaf(lambda x: type(x) is int, "a whole number")
amount = leaf(is_amount, "a finite number from 0 on")
error = leaf(lambda x: is_amount(x) or x == "infinity", 'a number from 0 on or "infinity"')
double = leaf(is_double, "[integer, exponent] of a double")
bracket_ends = leaf(is_bracket, "[low, high, exponent] of a bracket")
answer = leaf(lambda x: x in WORDS or is_double(x), "[integer, exponent] of a double, or a word")
triple, pixel = every(double, 3), every(whole, 2)
TRIPLES = ("origin", "direction", "eye", "look_at", "up", "centre")  # inputs that may change
SINGLES = ("near", "left", "right", "bottom", "top", "radius")
CAMERA = fields(
    {"eye": triple, "look_at": triple, "up": triple},
    {**dict.fromkeys(SINGLES[:5], double), "width": whole, "height": whole},
)
INPUTS = fields(
    {},
    {
        "ray": fields({"origin": triple, "direction": triple}),
        "camera": CAMERA,
        "pixel": pixel,
        "spheres": every(fields({"centre": triple, "radius": double})),
    },
)
MEETING = fields(
    {"discriminant": bracket_ends, "root": or_null(text)},
    dict.fromkeys(("c", "b", "s", "other_s"), bracket_ends),
)
ROOTS = ("|E - A|", "|up x (E - A)|", "|P - E|")
PROOF = fields(
    {},
    {
        "roots": fields({}, dict.fromkeys(ROOTS, bracket_ends)),
        "spheres": every(MEETING),
        "norms": every(bracket_ends),
    },
)
WITNESS = every(fields({"input": text, "share": leaf(is_share, "a finite hexadecimal float")}))
EXCUSE = fields({"kind": text}, {"amount": or_null(error), "witness": or_null(WITNESS)})
QUANTITIES = {  # and the number of numbers in an answer
    **dict.fromkeys(("class", "nearest sphere"), (0, 1)),
    **dict.fromkeys(("root", "parameter", "backward error"), (1,)),
    **dict.fromkeys(("frame", "pixel point", "ray origin", "direction", "unit defect"), (3,)),
    **dict.fromkeys(("hit point", "sphere residual", "ray residual"), (3,)),
    "orthonormality": (9,),
}
CERTIFIED = fields(
    {
        "quantity": leaf(lambda x: x in QUANTITIES, "one that can be certified"),
        "inputs": INPUTS,
        "proof": PROOF,
    }
)
CERTIFICATE = fields(
    {
        **dict.fromkeys(("method", "quantity", "unit", "what"), text),
        "precision": leaf(lambda x: x in tuple(FORMATS), "one of " + ", ".join(FORMATS)),
        "pixel": or_null(pixel),
        **dict.fromkeys(("ray", "sphere"), or_null(whole)),
        "wrong": or_null(text),
        "excuse": or_null(EXCUSE),
        "neighbourhood": or_null(amount),
        "error": error,
        **dict.fromkeys(("got", "exact"), every(answer)),
        "conventions": fields(dict.fromkeys(CONVENTIONS, text)),
        "certified": leaf(lambda x: isinstance(x, bool), "true or false"),
    }
)
NOT_CERTIFIED = fields({"reason": text})


def plain_integer(digits):
    if len(digits.lstrip("-")) > PLAIN_DIGITS:
        raise Malformed(f"an integer of more than {PLAIN_DIGITS} digits is not a string")
    return int(digits)


def certificate_of(line):
    """The certificate in a line of a file."""
    try:
        certificate = json.loads(line.decode("utf-8"), parse_int=plain_integer)
    except UnicodeDecodeError:
        raise Malformed("it is not UTF-8") from None
    except ValueError as problem:
        raise Malformed(f"it is not JSON: {problem}") from None
    except RecursionError:
        raise Malformed("it is nested too deeply") from None
    CERTIFICATE(certificate, "certificate")
    if not certificate["certified"]:
        NOT_CERTIFIED(certificate, "certificate")
    else:
        CERTIFIED(certificate, "certificate")
        if len(certificate["got"]) not in QUANTITIES[certificate["quantity"]]:
            raise Malformed("certificate.got has the wrong number of numbers for the quantity")
    return certificate


def number(pair):
    """[integer, exponent] is integer * 2^exponent; an integer beyond 2^53 is a string."""
    if not isinstance(pair, list):  # an input that was changed
        return pair
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


# A ray and a sphere: start + mu g, mu >= 0, on the line base + mu g. For given rays all numbers are
# Fractions and these three functions are the whole proof; for cameras' rays some are Intervals.


def equation(ray, centre, radius):
    """The a, b, c of a mu^2 - 2 b mu + c = 0, whose roots are on the sphere; and b^2 - a c."""
    T, moment = minus(centre, ray.start), cross(minus(centre, ray.base), ray.g)
    c, discriminant = dot(T, T) - radius**2, ray.a * radius**2 - dot(moment, moment)
    return ray.a, dot(T, ray.g), c, discriminant


def root_met(b, c, discriminant, conventions):
    """The root that the ray meets: "smaller", "larger", or None for a miss."""
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
    """All numbers from low to high. Results contain all values; comparisons must be certain."""

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
        if not (self.low > high or self.high <= low):
            raise Undecided("the brackets are too wide to decide a sign")
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
    """A bracket that is narrow enough for one number: an Interval, or that number."""
    low, high = stated_ends(stated)
    require(low <= high, "the low end of a bracket is above its high end")
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


def camera_axes(camera, root):
    w = minus(numbers(camera["eye"]), numbers(camera["look_at"]))
    u = cross(numbers(camera["up"]), w)
    w_length = root("|E - A|", dot(w, w))
    u_length = root("|up x (E - A)|", dot(u, u))
    W, U = [x / w_length for x in w], [x / u_length for x in u]
    return U, cross(W, U), W


def position(first, last, index, count, samples):
    steps = count - 1 if samples == "edges" else count
    share = Fraction(2 * index + (samples == "centres"), 2 * steps)
    return number(first) + share * (number(last) - number(first))


def camera_ray(camera, pixel, conventions, root):
    """n W + alpha U + beta V, from E or from P. Its square is n^2 + alpha^2 + beta^2."""
    (U, V, W), (i, j), samples = camera_axes(camera, root), pixel, conventions["samples"]
    rows = ("top", "bottom") if conventions["rows"] == "top-first" else ("bottom", "top")
    n = number(camera["near"])
    alpha = position(camera["left"], camera["right"], i, camera["width"], samples)
    beta = position(*(camera[side] for side in rows), j, camera["height"], samples)
    g = plus(plus(times(n, W), times(alpha, U)), times(beta, V))
    a = n**2 + alpha**2 + beta**2
    eye = numbers(camera["eye"])
    start = plus(eye, g) if conventions["origin"] == "pixel" else eye
    return Ray(eye, start, g, a, root("|P - E|", a), is_given=False)


def stated_roots(proof):
    """The square roots of a camera, as a certificate states them."""

    def root(name, square):
        require(name in proof.get("roots", {}), f"the bracket of {name} is missing")
        return square_root(proof["roots"][name], square)

    return root


def ray_of(inputs, conventions, root):
    """`root` returns the square roots of a camera, given their names and squares."""
    if "ray" in inputs:
        return given_ray(inputs["ray"])
    if "pixel" in inputs:
        return camera_ray(inputs["camera"], inputs["pixel"], conventions, root)
    return None


# Compares the statements of a certificate with computed values.


class Meeting:
    """The meeting of a ray and a sphere, recomputed and compared with the statements."""

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
                require(is_stated, f"{name} differs from the stated one")
        self.root = root_met(b, c, discriminant, conventions)
        require(self.root == stated["root"], "the root of the hit differs from the stated one")
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


def binary_exponent(x):
    """e of 2^(e-1) <= |x| < 2^e; the denominator of x, which is not 0, is a power of two."""
    return abs(x.numerator).bit_length() - x.denominator.bit_length() + 1


def rounded(x, precision="double"):
    """The number of the format nearest to x, ties to even."""
    if precision == "double":
        try:
            return float(x)
        except OverflowError:
            return float("inf") if x > 0 else float("-inf")
    if x == 0:
        return 0.0
    digits, least = FORMATS[precision]
    exponent = abs(x.numerator).bit_length() - x.denominator.bit_length()  # too large by at most 1
    gap = Fraction(2) ** max(exponent - digits, least)
    if abs(x) >= gap * 2**digits:
        gap *= 2
    nearest = round(abs(x) / gap) * gap
    value = float(nearest) if nearest < 2**128 else float("inf")
    return value if x > 0 else -value


def require_exact(stated, computed, precision):
    """The stated numbers are the computed ones, rounded to nearest."""
    require(len(stated) == len(computed), "the number of exact values differs from the stated one")
    size = max((abs(end) for x in computed for end in ends(x)), default=0)
    for double, x in zip(stated, computed):
        low, high = ends(x)
        require(high - low <= NARROW * size, "the brackets are too wide for the exact value")
        value = float(double) if isinstance(double, str) else rounded(number(double))
        in_format = rounded(low, precision) <= value <= rounded(high, precision)
        require(in_format, "the exact value differs from the stated one")


def require_error(stated, squares, unit):
    """Checks a stated error, in this unit: its square is a computed one, up to the tolerance."""
    for low, high in map(ends, squares):
        if stated == "infinity":
            if low >= INFINITE:
                return
            continue
        error = Fraction(stated) * unit
        slack = TOLERANCE * max(error, unit)
        if (error <= slack or (error - slack) ** 2 <= low) and high <= (error + slack) ** 2:
            return
    raise Refuted("the error differs from the stated one")


def relative_sq(gap_sq, size_sq):
    """The square of a relative error in units of u; if the true value is 0, it is 0 or INFINITE."""
    if ends(size_sq)[1] == 0:
        return 0 if ends(gap_sq)[1] == 0 else INFINITE
    return gap_sq / size_sq / U**2


def ulps_sq(got, s, precision):
    """The square of an error in ulp; at a power of two, where two gaps meet, in either."""
    digits, least = FORMATS[precision]

    def ulp(x):
        return Fraction(2) ** max(binary_exponent(x) - digits, least)

    if ends(s) == (0, 0):
        return [relative_sq(got**2, s)]
    return [((got - s) / ulp(end)) ** 2 for end in ends(s)]


def angle_sq(got, g):
    """The square of the angle's tangent in units of u."""
    cosine = dot(got, g)
    return norm_sq(cross(got, g)) / cosine**2 / U**2 if cosine > 0 else INFINITE


def first_order_reach(s, ray, centre, radius):
    """The most that a relative change of all inputs of a given ray adds to |T - s g|^2 - r^2."""
    way = times(s, ray.g)
    off = minus(plus(ray.start, way), centre)
    sizes = [sum(map(abs, parts)) for parts in zip(ray.start, centre, way)]
    return 2 * dot(list(map(abs, off)), sizes) + 2 * radius**2


def backward_sq(s, ray, met):
    """The square of the relative change of the inputs that makes s a root, in units of u."""
    off = minus(plus(ray.start, times(s, ray.g)), met.centre)
    reach = first_order_reach(s, ray, met.centre, met.radius)
    return relative_sq((norm_sq(off) - met.radius**2) ** 2, reach**2)


def orthonormality_sq(axes, norms):
    """The square of the largest defect of length and of mutual cosines."""
    if not dot(cross(axes[0], axes[1]), axes[2]) > 0:
        return INFINITE
    defects = [square_root(norm, norm_sq(axis)) - 1 for norm, axis in zip(norms, axes)]
    defects += [dot(axes[k], axes[(k + 1) % 3]) for k in range(3)]
    lows, highs = zip(*(ends((defect / U) ** 2) for defect in defects))
    return Interval(max(lows), max(highs))


def measured(certificate, ray, meetings, got):
    """The exact value, and a function that returns the square of the answer's error."""
    quantity, proof = certificate["quantity"], certificate["proof"]
    if quantity == "orthonormality":
        return [], lambda: [orthonormality_sq([got[0:3], got[3:6], got[6:9]], proof["norms"])]
    if quantity == "frame":
        axes = camera_axes(certificate["inputs"]["camera"], stated_roots(proof))
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
        require(met.root, "the ray misses the sphere")
        exact = met.point()
    if quantity == "parameter":
        return [met.s], lambda: ulps_sq(got[0], met.s, certificate["precision"])
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
    """Checks a wrong class or root."""
    wrong, answered = certificate["wrong"], bool(certificate["got"])
    require_exact(certificate["exact"], [met.s] if met.root else [], certificate["precision"])
    if certificate["quantity"] == "class":
        stated = {"missed": (True, False), "false hit": (False, True)}[wrong]
        require((bool(met.root), answered) == stated, f"it is not a case of: {wrong}")
        return
    require(wrong == "wrong root" and met.root, "the ray misses, so the root cannot be wrong")
    gap_sq, apart_sq = (got[0] - met.other_s) ** 2, (met.s - met.other_s) ** 2
    require(16 * gap_sq < apart_sq, "the answer is not at the other root")


def confirm_nearest(certificate, meetings):
    exact = [int(x) for x in numbers(certificate["exact"])]
    # If a picture shows a sphere of unknown number, that is right if the ray hits any sphere.
    is_untold = certificate["got"] == [SOME_SPHERE]
    got = [] if is_untold else [int(x) for x in numbers(certificate["got"])]
    require(not (exact and is_untold), "the ray hits a sphere, as was answered")
    require(exact or got or is_untold, "the ray misses all spheres, as was answered")
    wrong = {(1, 1): "wrong sphere", (1, 0): "missed", (0, 1): "false hit",
             (0, 0): "false hit"}[len(exact), len(got)]
    require(wrong == certificate["wrong"], "the answer is wrong in another way than stated")
    if not exact:
        require(not any(met.root for met in meetings), "the ray hits a sphere")
        return
    require(all(k in range(len(meetings)) for k in exact + got), "a sphere number is out of range")
    first = meetings[exact[0]]
    require(first.root, "the ray misses the sphere")
    for k, met in enumerate(meetings):
        same = met.centre == first.centre and met.radius == first.radius
        if met.root and (k in got or not same):
            low, high = ends(met.s)[0], ends(first.s)[1]
            require(low > high if k in got else low >= high, "the ray hits another sphere first")


# A wrong decision is excused if it is right for nearby inputs; if there are none, it is a defect.
# Every input x may become x (1 + share), |share| <= amount.


def named_inputs(inputs, of_many_spheres):
    """The place of each input that may change, by its name: the containing object and its key."""
    holders = [("", inputs["ray"] if "ray" in inputs else inputs["camera"])]
    for k, sphere in enumerate(inputs["spheres"]):
        holders.append((f"spheres[{k}]." if of_many_spheres else "", sphere))
    places = {}
    for prefix, holder in holders:
        for key, value in holder.items():
            if key in TRIPLES:
                for k, axis in enumerate("xyz"):
                    places[f"{prefix}{key}.{axis}"] = (value, k)
            elif key in SINGLES:
                places[prefix + key] = (holder, key)
    return places


def change_inputs(certificate, change):
    """The inputs, with each number replaced by change(its name, its number)."""
    inputs = json.loads(json.dumps(certificate["inputs"]))
    is_choice = certificate["quantity"] == "nearest sphere"
    for name, (holder, key) in named_inputs(inputs, is_choice).items():
        holder[key] = change(name, number(holder[key]))
    return inputs


def root_of(x, bits):
    """The square root of a number, of an Interval, or of a Dual."""
    if isinstance(x, Dual):
        root = root_of(x.value, bits)
        return Dual(root, {name: slope / (2 * root) for name, slope in x.slopes.items()})
    if isinstance(x, Interval):
        return Interval(ends(root_of(max(x.low, 0), bits))[0], ends(root_of(x.high, bits))[1])
    n, d = Fraction(x).as_integer_ratio()
    shift = max(0, 2 * bits - n.bit_length() + d.bit_length() + 1) // 2
    whole, rest = divmod(n << 2 * shift, d)
    low = isqrt(whole)
    is_exact = rest == 0 and low * low == whole
    low, high = Fraction(low, 1 << shift), Fraction(low + 1, 1 << shift)
    return low if is_exact else Interval(low, high)


def outward(x):
    """An Interval with ends of fewer digits; a number stays as it is."""
    if not isinstance(x, Interval):
        return x
    rounded_ends = []
    for sign, end in ((1, x.low), (-1, x.high)):
        n, d = Fraction(sign * end).as_integer_ratio()
        shift = ROOT_BITS[0] - abs(n).bit_length() + d.bit_length()
        down = Fraction((n << max(shift, 0)) // (d << max(-shift, 0)))
        rounded_ends.append(sign * down / Fraction(2) ** shift)
    return Interval(*rounded_ends)


class Dual:
    """A number and its derivatives by the changes of inputs, by the names of the inputs."""

    def __init__(self, value, slopes):
        self.value, self.slopes = value, slopes

    def linear(self, value, mine, other=None, theirs=0):
        """A value with its derivatives."""
        slopes = {name: mine * slope for name, slope in self.slopes.items()}
        for name, slope in (other.slopes if isinstance(other, Dual) else {}).items():
            slopes[name] = theirs * slope + slopes.get(name, 0)
        return Dual(outward(value), {name: outward(slope) for name, slope in slopes.items()})

    def __neg__(self):
        return self.linear(-self.value, -1)

    def __add__(self, other):
        return self.linear(self.value + value_of(other), 1, other, 1)

    def __sub__(self, other):
        return self.linear(self.value - value_of(other), 1, other, -1)

    def __mul__(self, other):
        return self.linear(self.value * value_of(other), value_of(other), other, self.value)

    def __truediv__(self, other):
        ratio, inverse = self.value / value_of(other), 1 / value_of(other)
        return self.linear(ratio, inverse, other, -ratio * inverse)

    def __pow__(self, two):
        return self * self

    __radd__ = __add__
    __rmul__ = __mul__


def value_of(x):
    return x.value if isinstance(x, Dual) else x


def least(x):
    """A lower bound on |x|."""
    low, high = ends(x)
    return max(low, -high, Fraction(0))


def most(x):
    """An upper bound on |x|."""
    return max(map(abs, ends(x)))


def slack_of(s, ray, centre, amount, bound):
    """How far an answer's s may be off, at least or at most: its share of s and of the way to the
    centre."""
    way = max(map(bound, minus(centre, ray.start)))
    return amount * (s + (way / max(map(abs, ray.g)) if ray.is_given else way))


def reach_of(s, certificate, ray, amount, bits, bound):
    """R: what the changes add to |T - s g|^2 - r^2, to first order, at least or at most."""
    (sphere,) = certificate["inputs"]["spheres"]
    if ray.is_given:
        centre, radius = numbers(sphere["centre"]), number(sphere["radius"])
        return amount * first_order_reach(s, ray, centre, radius)
    inputs = change_inputs(certificate, lambda name, x: Dual(x, {name: x}))
    ray = ray_of(inputs, certificate["conventions"], lambda _, square: root_of(square, bits))
    (sphere,) = inputs["spheres"]
    way = [x / ray.unit * s for x in ray.g]
    at_answer = norm_sq(minus(minus(sphere["centre"], ray.start), way)) - sphere["radius"] ** 2
    return amount * sum(map(bound, at_answer.slopes.values()))


def is_answer_right(certificate, ray, changed, changed_ray, bits):
    """Whether a changed ray and sphere meet, or miss, as in the answer."""
    conventions, amount = certificate["conventions"], Fraction(certificate["excuse"]["amount"])
    (sphere,) = changed["spheres"]
    a, b, c, discriminant = equation(changed_ray, sphere["centre"], sphere["radius"])
    root = root_met(b, c, discriminant, conventions)
    if not (root and certificate["got"]):
        return bool(root) == bool(certificate["got"])
    if isinstance(certificate["got"][0], str):  # no number
        return False
    s = number(certificate["got"][0])
    if s < 0:
        return False
    centre = numbers(certificate["inputs"]["spheres"][0]["centre"])
    slack = slack_of(s, ray, centre, amount, least)
    low, high = ((s + off) / changed_ray.unit for off in (-slack, slack))
    if is_root_between(ends(low)[1], ends(high)[0], root, a, b, c):
        return True
    # Near a double root: a (|mu - mu'| + |mu' - mu''|)^2 <= R.
    half = root_of(discriminant, bits)
    met = b - half if root == "smaller" else b + half
    apart = most(a * (s / changed_ray.unit) - met) + 2 * most(half)
    return apart**2 <= reach_of(s, certificate, ray, amount, bits, least) * least(a)


def is_choice_right(certificate, changed, ray, bits):
    """Whether a changed ray meets the answered sphere first; ties count."""
    conventions, got = certificate["conventions"], certificate["got"]
    met = {}
    for k, sphere in enumerate(changed["spheres"]):
        _, b, c, discriminant = equation(ray, sphere["centre"], sphere["radius"])
        root = root_met(b, c, discriminant, conventions)
        if root and conventions["tangent"] == "either" and not discriminant > 0:
            return False  # not judged
        if root:
            half = root_of(discriminant, bits)
            met[k] = (b - half if root == "smaller" else b + half), (b, discriminant, root)
    if not got or got == [SOME_SPHERE]:
        return bool(met) == bool(got)
    said = int(number(got[0]))
    if said not in met:
        return False
    at, equal = met[said]
    return all(each == equal or not at > other for other, each in met.values())


def confirm_witness(certificate, ray):
    """Checks that the answer is right for the inputs of its witness."""
    excuse, shares = certificate["excuse"], {}
    amount = Fraction(excuse["amount"])
    require(amount == Fraction(certificate["neighbourhood"]), "the neighbourhood is not the amount")
    for entry in excuse["witness"]:
        name, share = entry["input"], Fraction(float.fromhex(entry["share"]))
        require(abs(share) <= amount, "the witness changes an input by more than its amount")
        require(name not in shares, "the witness changes an input twice")
        shares[name] = share
    known = named_inputs(certificate["inputs"], certificate["quantity"] == "nearest sphere")
    require(set(shares) <= set(known), "the witness changes something that is not an input")
    changed = change_inputs(certificate, lambda name, x: x * (1 + shares.get(name, 0)))

    def is_right(bits):
        roots = lambda _, square: root_of(square, bits)
        changed_ray = ray_of(changed, certificate["conventions"], roots)
        if certificate["quantity"] == "nearest sphere":
            return is_choice_right(certificate, changed, changed_ray, bits)
        return is_answer_right(certificate, ray, changed, changed_ray, bits)

    try:
        found = is_right(ROOT_BITS[0])
    except Undecided:
        found = is_right(ROOT_BITS[1])
    require(found, "the answer is not right for the inputs of its witness")


# Mean-value forms over the box of all nearby inputs prove that none is right. Inputs matter only
# through T = C - L, g, r and s, in multiples of g. Each function below takes these four and returns
# its value and its derivatives by them.


def discriminant_form(T, g, r, s):
    moment, a = cross(T, g), norm_sq(g)
    by_g = minus(times(r**2, g), cross(moment, T))
    slopes = [*times(-2, cross(g, moment)), *times(2, by_g), 2 * (a * r), 0]
    return a * r**2 - norm_sq(moment), slopes


def constant_form(T, g, r, s):
    return norm_sq(T) - r**2, [*times(2, T), 0, 0, 0, -2 * r, 0]


def linear_form(T, g, r, s):
    return dot(T, g), [*g, *T, 0, 0]


def at_answer_form(T, g, r, s):
    """|T - s g|^2 - r^2, which is 0 if s is a root."""
    off = minus(T, times(s, g))
    slopes = [*times(2, off), *times(-2 * s, off), -2 * r, -2 * dot(off, g)]
    return norm_sq(off) - r**2, slopes


def before_middle_form(T, g, r, s):
    """b - a s, which is not negative if s is the smaller root."""
    a = norm_sq(g)
    return dot(T, g) - s * a, [*g, *minus(T, times(2 * s, g)), 0, -a]


def other_behind_form(T, g, r, s):
    """a s - 2 b, which is not negative if the other root is not positive."""
    a = norm_sq(g)
    return s * a - 2 * dot(T, g), [*times(-2, g), *times(2, minus(times(s, g), T)), 0, a]


class Variation:
    """value + sum of t_k reach_k, |t_k| <= 1, contains a function's values all over a box."""

    def __init__(self, value, reach):
        self.value, self.reach = value, reach
        self.spread = sum(map(most, reach))
        self.low, self.high = ends(value)[0] - self.spread, ends(value)[1] + self.spread

    def shifted(self, sign, shift):
        return Variation(sign * self.value + shift, [sign * x for x in self.reach])

    def plus(self, factor, other):
        reach = [x + factor * y for x, y in zip(self.reach, other.reach)]
        return Variation(self.value + factor * other.value, reach)


class Nearby:
    """A ray and a sphere whose inputs change by at most the certificate's neighbourhood: T, g, r
    and |g|, in the middle and over the whole box; how they change with each input, as Duals."""

    def __init__(self, certificate):
        amount = Fraction(certificate["neighbourhood"])
        self.middle = self.arguments(certificate, lambda name, x: Dual(x, {}))
        self.whole = self.arguments(certificate, lambda name, x: around(x, amount * abs(x), name))

    @staticmethod
    def arguments(certificate, change):
        inputs = change_inputs(certificate, change)
        roots = lambda _, square: root_of(square, ROOT_BITS[0])
        ray = ray_of(inputs, certificate["conventions"], roots)
        (sphere,) = inputs["spheres"]
        T = minus(sphere["centre"], ray.start)
        return [*T, *ray.g, sphere["radius"]], ray.unit

    def box(self, s_low, s_high):
        """What T, g, r and mu may be: s, in multiples of g, in a range."""
        half = (s_high - s_low) / 2
        sizes = (Dual(s_low + half, {}), self.middle), (around(s_low + half, half, "s"), self.whole)
        return Box(*([*numbers, s / unit] for s, (numbers, unit) in sizes))


def around(x, half, name):
    """All numbers from x - half to x + half."""
    return Dual(Interval(x - half, x + half), {name: half} if half else {})


class Box:
    def __init__(self, middle, whole):
        self.middle, self.whole = (self.arguments(numbers) for numbers in (middle, whole))
        self.steps = [x.slopes for x in whole]

    @staticmethod
    def arguments(numbers):
        values = [value_of(x) for x in numbers]
        return values[0:3], values[3:6], *values[6:8]

    def variation(self, form):
        """By the mean-value form: value in the middle, derivatives over the whole box."""
        reach = {}
        for slope, steps in zip(form(*self.whole)[1], self.steps):
            for name, step in steps.items():
                reach[name] = reach.get(name, 0) + slope * step
        names = sorted({name for steps in self.steps for name in steps})
        return Variation(form(*self.middle)[0], [reach[name] for name in names])


def exclude_each_other(f, g, g_is_zero=False):
    """Whether f and g are nowhere both >= 0 (g = 0): f + m g < 0 everywhere for some m >= 0 (any
    m). Which m is a guess in floats, where a term of the sum turns; the proof is of that m."""
    if f.high < 0 or g.high < 0 or (g_is_zero and g.low > 0):
        return True
    if f.spread == 0 or g.spread == 0:
        return False
    share = lambda x, spread: float(sum(ends(x)) / 2 / spread)
    slopes = [(share(x, f.spread), share(y, g.spread)) for x, y in zip(f.reach, g.reach)]
    f_value, g_value = share(f.value, f.spread), share(g.value, g.spread)
    high = lambda m: f_value + m * g_value + sum(abs(x + m * y) for x, y in slopes)
    guesses = [-x / y for x, y in slopes if y != 0]
    for m in sorted((m for m in guesses if abs(m) < 2**500 and (g_is_zero or m > 0)), key=high)[:2]:
        if f.plus(Fraction(m) * f.spread / g.spread, g).high < 0:
            return True
    return False


def room_along(vector, most_sq):
    """Negative wherever a vector of three variations is longer than the root of `most_sq` along one
    direction, that of the shortest that is found, guessed in floats."""
    size = max(max(most(v.value), v.spread) for v in vector) or 1
    share = lambda x: float(sum(ends(x)) / 2 / size)
    at = [share(v.value) for v in vector]
    reach = [[share(x) for x in of_one] for of_one in zip(*(v.reach for v in vector))]
    t = [0.0] * len(reach)
    for _ in range(40):
        for k, step in enumerate(reach):
            square = dot(step, step)
            if square > 0:
                to = min(1.0, max(-1.0, t[k] - dot(at, step) / square))
                at, t[k] = plus(at, times(to - t[k], step)), to
    u = list(map(Fraction, at))
    along = vector[0].shifted(-u[0], 0).plus(-u[1], vector[1]).plus(-u[2], vector[2])
    return along.shifted(1, ends(root_of(norm_sq(u) * most_sq, ROOT_BITS[0]))[1])


def vector_variations(box, form):
    """The variations of three functions, given as one function that also takes an axis."""
    return [box.variation(lambda *arguments, k=k: form(k, *arguments)) for k in range(3)]


def moment_form(axis, T, g, r, s):
    """T x g, which is as long as r |g| if the line touches the sphere."""
    u = [Fraction(k == axis) for k in range(3)]
    return cross(T, g)[axis], [*cross(g, u), *cross(u, T), 0, 0]


def off_form(axis, T, g, r, s):
    """T - s g, which is as long as r if s is a root."""
    u = [Fraction(k == axis) for k in range(3)]
    return (T[axis] - s * g[axis]), [*u, *[-1 * s * x for x in u], 0, -1 * g[axis]]


def unit_vector(quarters, t):
    """A direction of the plane: a quarter turn for t from 0 to 1, after full `quarters`."""
    x, y = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
    for _ in range(quarters):
        x, y = -y, x
    return x, y


def is_shorter(vector, across, least_sq):
    """Whether a vector of three variations, nearly perpendicular to `across`, is shorter everywhere
    than the root of `least_sq`: in sectors of the plane, each halved where that is not shown."""
    size = max(map(most, across))
    axis = [float(ends(x)[0] / size) for x in across]
    least_axis = min(range(3), key=lambda k: abs(axis[k]))
    other = [float(k == least_axis) for k in range(3)]
    frame = [axis, cross(axis, other), cross(axis, cross(axis, other))]
    frame = [[Fraction(x / dot(v, v) ** 0.5) for x in v] for v in frame]
    # For a nearly orthonormal frame F, |F v|^2 >= (1 - defect) |v|^2.
    defect = max(sum(abs(dot(v, w) - (v is w)) for w in frame) for v in frame)
    along = lambda v: vector[0].shifted(v[0], 0).plus(v[1], vector[1]).plus(v[2], vector[2])
    rest, first, second = map(along, frame)
    least_sq = least_sq * (1 - defect) - max(abs(rest.low), abs(rest.high)) ** 2
    if least_sq <= 0:
        return False
    sectors = [(quarters, Fraction(0), Fraction(1)) for quarters in range(4)]
    for quarters, low, high in sectors:
        # p = x u + y v, x and y >= 0, has length at most x + y = p.(u + v) / (1 + u.v).
        u, v = unit_vector(quarters, low), unit_vector(quarters, high)
        x, y = plus(u, v)
        longest = first.shifted(x, 0).plus(y, second).high / (1 + dot(u, v))
        if longest > 0 and longest**2 >= least_sq:
            if len(sectors) >= MOST_SECTORS:
                return False
            middle = (low + high) / 2
            sectors += [(quarters, low, middle), (quarters, middle, high)]
    return True


def is_met_everywhere(box, conventions):
    """Checks that no ray and sphere of the box miss each other."""
    discriminant, b = box.variation(discriminant_form), box.variation(linear_form)
    if discriminant.low < 0 or (discriminant.low == 0 and conventions["tangent"] == "miss"):
        _, g, r, _ = box.whole
        least_sq = r.low**2 * norm_sq(g).low
        moment = vector_variations(box, moment_form)
        if r.low <= 0 or not is_shorter(moment, box.middle[1], least_sq):
            return False
    c = box.variation(constant_form)
    if conventions["root"] == "smaller":
        return c.low >= 0 and b.low >= 0
    return c.high <= 0 or b.low >= 0


def is_hit_nowhere(s, box_of, slack, reach, conventions):
    """Checks that no ray and sphere of the box meet at s, or so near to s that it counts."""
    box = box_of(max(s - slack, Fraction(0)), s + slack)
    _, g, r, _ = box.whole
    root, ways = box.variation(at_answer_form), [before_middle_form]
    if conventions["root"] == "nearest":
        ways.append(other_behind_form)
    if not all(exclude_each_other(box.variation(way), root, g_is_zero=True) for way in ways):
        if room_along(vector_variations(box, off_form), r.high**2).high >= 0:
            return False
    return is_no_double_root(box_of(s, s), reach, r, norm_sq(g).high)


def is_no_double_root(box, reach, r, a_most):
    """Near a double root both are within sqrt(R/a) of s: |b - a s| <= sqrt(R a), and as half the
    distance of the roots is at most half of that, 0 <= 4 (b^2 - a c) <= R a."""
    most_sq = reach * a_most
    away = ends(root_of(most_sq, ROOT_BITS[0]))[1]
    discriminant, before = box.variation(discriminant_form), box.variation(before_middle_form)
    not_before, not_behind = before.shifted(-1, away), before.shifted(1, away)
    small = discriminant.shifted(-1, most_sq / 4)
    if any(f.high < 0 for f in (discriminant, not_before, not_behind, small)):
        return True
    of_place = (not_before, not_behind)
    if any(exclude_each_other(f, g) for f in (discriminant, small) for g in of_place):
        return True
    room = room_along(vector_variations(box, moment_form), (r**2).high * a_most)
    return any(exclude_each_other(room, g) for g in of_place)


def is_right_nowhere(certificate, ray):
    """Whether the answer is proved wrong for all inputs of the neighbourhood."""
    amount, conventions = Fraction(certificate["neighbourhood"]), certificate["conventions"]
    nearby = Nearby(certificate)
    if not certificate["got"]:
        return is_met_everywhere(nearby.box(Fraction(0), Fraction(0)), conventions)
    if isinstance(certificate["got"][0], str):  # no number
        return True
    s = number(certificate["got"][0])
    if s < 0:
        return True
    centre = numbers(certificate["inputs"]["spheres"][0]["centre"])
    slack = slack_of(s, ray, centre, amount, most)
    reach = reach_of(s, certificate, ray, amount, ROOT_BITS[0], most)
    return is_hit_nowhere(s, nearby.box, slack, reach, conventions)


# The messages on wrong decisions: excused by a witness, or stated to be defects.
BY_WITNESS, PROVED, NOT_PROVED = (
    "right for its witness",
    "proved wrong for all inputs nearby",
    "not proved wrong for all inputs nearby",
)


def confirm_standing(certificate, ray):
    """The proved standing of a wrong decision; None if the certificate claims nothing provable."""
    excuse = certificate["excuse"]
    if excuse is None:
        is_choice = certificate["quantity"] == "nearest sphere"
        try:
            return PROVED if not is_choice and is_right_nowhere(certificate, ray) else NOT_PROVED
        except (Refuted, ArithmeticError):  # so wide that a camera of it may have no axes, say
            return NOT_PROVED
    if excuse["kind"] != "witness":
        return None
    confirm_witness(certificate, ray)
    return BY_WITNESS


def confirm(certificate):
    """The proved standing of a wrong decision, or None. Raises Refuted unless the inputs prove the
    statements of the certificate."""
    inputs, proof = certificate["inputs"], certificate["proof"]
    conventions, quantity = certificate["conventions"], certificate["quantity"]
    for name, values in CONVENTIONS.items():
        require(conventions[name] in values, f"unknown convention of {name}: {conventions[name]}")
    require(certificate["pixel"] == inputs.get("pixel"), "the pixel is not that of the inputs")
    ray = ray_of(inputs, conventions, stated_roots(proof))
    spheres, stated = inputs.get("spheres", []), proof.get("spheres", [])
    require(len(spheres) == len(stated), "a sphere's proof is missing")
    meetings = [Meeting(ray, *each, conventions) for each in zip(spheres, stated)]
    if quantity == "nearest sphere":
        confirm_nearest(certificate, meetings)
        return confirm_standing(certificate, ray)
    is_finite = not any(isinstance(x, str) for x in certificate["got"])
    got = numbers(certificate["got"]) if is_finite else None
    if quantity in ("class", "root"):
        (met,) = meetings
        confirm_met(certificate, met, got)
        return confirm_standing(certificate, ray)
    require(certificate["wrong"] is None, "an error is measured, not a decision")
    precision, unit = certificate["precision"], "ulp" if quantity == "parameter" else "u"
    named = unit if precision == "double" else unit + " of float"
    require(certificate["unit"] == named, "the unit does not match the quantity and the precision")
    exact, squares = measured(certificate, ray, meetings, got)
    require_exact(certificate["exact"], exact, precision)
    size = 1 if unit == "ulp" else 2 ** (FORMATS["double"][0] - FORMATS[precision][0])
    require_error(certificate["error"], squares() if is_finite else [INFINITE], size)
    return None


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
    """The verdict on a certificate, the reason, and the standing of a wrong decision."""
    if not certificate["certified"]:
        return "not certified", certificate["reason"], None
    try:
        return "confirmed", "", confirm(certificate)
    except Refuted as reason:
        return "REFUTED", str(reason), None
    except ArithmeticError as problem:
        return "REFUTED", f"computing with its numbers fails: {problem}", None
    except (AttributeError, LookupError, TypeError, ValueError):
        raise Malformed("it lacks values that the proof of its quantity needs") from None


def visible(text):
    """The text without control characters."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


def certificates_in(path):
    with open(path, "rb") as file:
        for at, line in enumerate(file, 1):
            try:
                certificate = certificate_of(line)
                yield certificate, judge(certificate)
            except Malformed as problem:
                raise Malformed(f"{path}:{at}: {problem}") from None


def main(paths):
    counts = {"confirmed": 0, "REFUTED": 0, "not certified": 0}
    decisions = {BY_WITNESS: 0, PROVED: 0, NOT_PROVED: 0}
    for path in paths:
        for certificate, (state, why, standing) in certificates_in(path):
            counts[state] += 1
            text = f"{state}  {title(certificate)}" + (f": {why}" if why else "")
            if standing:
                decisions[standing] += 1
                text += f"; {standing}"
            print(visible(text))
    print(", ".join(f"{count} {state.lower()}" for state, count in counts.items()))
    if any(decisions.values()):
        parts = (f"{count} {standing}" for standing, count in decisions.items() if count)
        print("wrong decisions: " + ", ".join(parts))
    return 1 if counts["REFUTED"] else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    try:
        if sys.stdout is None:
            raise OSError("standard output is closed")
        sys.stdout.reconfigure(errors="backslashreplace")  # for characters that the encoding lacks
        sys.exit(main(sys.argv[1:]))
    except (Malformed, OSError) as problem:
        print(f"verify_certificates.py: {visible(str(problem))}", file=sys.stderr)
        sys.exit(2)
