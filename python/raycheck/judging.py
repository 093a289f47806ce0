"""Judges a Python function over arrays by raycheck's laws."""

from raycheck import _core


def candidate(function, *, name=None, returns="parameter", directions="any", level="ordinary",
              precision="double", roots=None, tangent="hit", lengths=(0, 0)):
    """A function, and what it promises.

    function(origins, directions, centre, radius): (N, 3), (N, 3), (3,) and a number -> by returns:
        "parameter"  s, (N,), in multiples of the direction; NaN for a miss
        "distance", "squared-distance"  that of the hit from the origin, (N,); NaN for a miss
        "point"      the hits, (N, 3); NaN for a miss
        "hit"        a pair of s and points
        "class"      whether rays hit, (N,)
    directions: "any", or "unit" if it is only right for directions of length 1.
    level: "ordinary", "demanding" or "extreme", the difficulty of the cases.
    precision: "single" if it computes in floats: inputs are then floats, as doubles.
    roots: Roots(...) that it accepts; None: every s >= 0.
    tangent: "hit", "miss" or "either".
    lengths: the smallest and the largest length for which it is right; (0, 0): all.
    """
    label = name or getattr(function, "__name__", "candidate")
    label = "".join(c if c.isalnum() or c in "-_." else "-" for c in label)
    return _core.Judged(function, label, returns, directions, level, precision, roots, tangent,
                        tuple(map(float, lengths)))


def judge(function, law="class", source="", *, cases=500, seed=1, **promises):
    """A Verdict on a function by one law (`raycheck list` shows them), on random cases.

    source: a source of cases, such as "distance@3"; "": all of the level.
    promises: as of candidate(). The function is called once for all rays of a case.
    """
    return candidate(function, **promises).judge(law, source, cases, seed)
