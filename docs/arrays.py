#!/usr/bin/python3
"""Prints a table of docs/performance.md: the module for NumPy beside other ways to the same answers.

It needs the module in build/release/python, mpmath and SymPy. Times of a way are those of its fastest of three runs.
"""
import fractions
import math
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "build/release/python"))
import mpmath
import numpy as np
import raycheck
import sympy
from raycheck import _core

HARD, SLOW = 4000, 300  # rays of all sources, and those of them that SymPy answers


def ordinary_rays(count):
    random = np.random.default_rng(1)
    origins, centres = random.uniform(-10, 10, (2, count, 3))
    radii = random.uniform(0.5, 5, count)
    return origins, centres + random.uniform(-1, 1, (count, 3)) * radii[:, None] - origins, centres, radii


def hard_rays():
    """One ray and one sphere of each case, of all sources without a camera, up to demanding severities."""
    sources = [(name, demanding if dial else 0)
               for name, _, has_camera, dial, _, _, demanding in _core.sources() if not has_camera]
    cases = []
    for seed in range(HARD):
        name, most = sources[seed % len(sources)]
        case = _core.make_case(name, seed, 0, seed // len(sources) % (most + 1))
        cases.append([case[key][0] for key in ("origins", "directions", "centres", "radii")])
    return [np.array(part) for part in zip(*cases)]


def nearest(a, b, c, discriminant, root):
    """Whether a root counts, and the smallest that does."""
    if discriminant < 0 or (c > 0 and b < 0):
        return False, math.nan
    root = root(discriminant)
    return True, float((b - root) / a if c >= 0 and b >= 0 else (b + root) / a)


def by_numbers(number, root):
    def answer(origin, direction, centre, radius):
        T = [number(float(c)) - number(float(o)) for c, o in zip(centre, origin)]
        d = [number(float(x)) for x in direction]
        a, b = sum(x * x for x in d), sum(x * y for x, y in zip(T, d))
        c = sum(x * x for x in T) - number(float(radius)) ** 2
        return nearest(a, b, c, b * b - a * c, root)
    return lambda *rays: [np.array(part) for part in zip(*map(answer, *rays))]


def root_of_fraction(x):
    """sqrt(x), off by at most 2^-400 of it."""
    return fractions.Fraction(math.isqrt(x.numerator * x.denominator << 800), x.denominator << 400)


def by_arrays(origins, directions, centres, radii):
    T = centres - origins
    with np.errstate(all="ignore"):
        a, b = (directions**2).sum(1), (T * directions).sum(1)
        root = np.sqrt(b * b - a * ((T**2).sum(1) - radii**2))
        s = np.where(b - root >= 0, b - root, b + root) / a
        return s >= 0, s


def by_raycheck(*rays):
    met = raycheck.decide(*rays)
    return met.hit_class > 0, met.s


def seconds_a_ray(answer, rays):
    times = []
    for _ in range(3):
        start = time.perf_counter()
        answer(*rays)
        times.append(time.perf_counter() - start)
    return min(times) / len(rays[0])


def table():
    exact = by_numbers(fractions.Fraction, root_of_fraction)
    mpmath.mp.dps = 50
    ways = [("`raycheck.decide`", by_raycheck, 10**6, HARD),
            ("NumPy, the textbook's formula", by_arrays, 10**6, HARD),
            ("`fractions`, `math.isqrt`", exact, 1000, HARD),
            ("mpmath, 50 digits", by_numbers(mpmath.mpf, mpmath.sqrt), 1000, HARD),
            ("SymPy, `Rational`, `sqrt`", by_numbers(sympy.Rational, lambda x: sympy.sqrt(x)), 100, SLOW)]
    ordinary, hard = ordinary_rays(10**6), hard_rays()
    first = None
    print("| way | ns a ray | times as long | hard rays | wrong classes | s off by more than 1 ulp | most, ulp |")
    print("|---|---|---|---|---|---|---|")
    for name, answer, some, count in ways:
        time_a_ray = seconds_a_ray(answer, [part[:some] for part in ordinary])
        first = first or time_a_ray
        rays = [part[:count] for part in hard]
        is_hit, s = answer(*rays)
        errors = raycheck.errors(*rays, is_hit=is_hit, s=s)
        is_wrong, off = errors.hit_class != 0, errors.s_ulp[errors.s_ulp > 1]
        print(f"| {name} | {1e9 * time_a_ray:,.3g} | {time_a_ray / first:,.3g} | {count} | {is_wrong.sum()} | {len(off)} | "
              f"{np.nanmax(errors.s_ulp):.2g} |")


def status(field):
    """Bytes from /proc/self/status."""
    lines = pathlib.Path("/proc/self/status").read_text().splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith(field + ":"))


def memory(count):
    """The memory that a call takes besides the arrays that are given and returned, as a share of these."""
    directions = np.ones((count, 3))
    directions[:, 0] = np.linspace(-1, 1, count)
    pathlib.Path("/proc/self/clear_refs").write_text("5")  # the peak is now the present size
    before = status("VmRSS")
    met = raycheck.decide([0, 0, 0], directions, [0, 0, 5], 1, points=False)
    returned = sum(part.nbytes for part in met.arrays.values())
    more = status("VmHWM") - before - returned
    return (f"{count:,} rays in one call are {(directions.nbytes + returned) / 1e9:.2f} GB of arrays; the call takes "
            f"{more / (directions.nbytes + returned):.2%} of that besides.")


if __name__ == "__main__":
    sentence = memory(10**8)  # first: memory that was freed before would be used again
    table()
    print("\n" + sentence)
