"""Assertions for pytest, and strategies for Hypothesis."""

import numpy as np

from raycheck import _core
from raycheck.judging import candidate


def assert_right(function, *, cases=500, seed=1, laws=None, **promises):
    """Raises AssertionError, with the shrunk case, unless the function passes all laws about it.

    promises: as of raycheck.judging.candidate(). laws: names of those that are judged; None: all.
    """
    asked = candidate(function, **promises)
    known = dict.fromkeys(law for law, _ in asked.checks())
    names = list(known) if laws is None else [laws] if isinstance(laws, str) else list(laws)
    for law in names:
        if law not in known:
            raise ValueError(f"laws: {law} does not apply to the function; {', '.join(known)} do")
    verdicts = [asked.judge(law, "", cases, seed) for law in names]
    broken = [verdict.text for verdict in verdicts if not verdict.passes]
    if broken:
        raise AssertionError("\n".join(broken))
    if not any(verdict.finding == "holds" for verdict in verdicts):
        raise AssertionError("no law could judge the function:\n" +
                             "".join(verdict.text for verdict in verdicts))


def rays_and_spheres(level="ordinary"):
    """A Hypothesis strategy of (origin, direction, centre, radius), (3,), (3,), (3,) and a number.

    They come from raycheck's sources of cases, at severities up to the level; examples shrink to
    the first sources, the mildest severities and the smallest seeds.
    """
    from hypothesis import strategies

    levels = ("ordinary", "demanding", "extreme")
    if level not in levels:
        raise ValueError(f"level = {level}: must be {', '.join(levels[:-1])} or {levels[-1]}")
    place = levels.index(level)
    sources = []
    for name, _, has_camera, dial, highest, ordinary, demanding in _core.sources():
        if has_camera or (not dial and place < 2):
            continue
        sources.append((name, (ordinary, demanding, highest)[place] if dial else 0))

    @strategies.composite
    def drawn(draw):
        name, most = draw(strategies.sampled_from(sources))
        severity = draw(strategies.integers(0, most))
        case = _core.make_case(name, draw(strategies.integers(0, 2**32 - 1)), 0, severity)
        ray = draw(strategies.integers(0, len(case["origins"]) - 1))
        sphere = draw(strategies.integers(0, len(case["radii"]) - 1))
        return (case["origins"][ray], case["directions"][ray], case["centres"][sphere],
                np.float64(case["radii"][sphere]))

    return drawn()
