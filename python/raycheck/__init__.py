"""Exact answers about rays and spheres, for NumPy arrays.

    import numpy as np
    import raycheck

    rays = np.random.default_rng(1).normal(size=(1000, 3))
    met = raycheck.decide([0, 0, -5], rays, [0, 0, 0], 1)
    met.hit_class                       # exact
    met.s, met.s_error                  # with a certified bound of the error

Every function's docstring gives shapes and units; raycheck.testing judges your own functions.
"""

from raycheck._core import (Answers, Camera, Roots, Verdict, condition, decide, enclose, errors,
                            nearest, round)
from raycheck.judging import judge

__all__ = ["Answers", "Camera", "Roots", "Verdict", "condition", "decide", "enclose", "errors",
           "image", "judge", "nearest", "round"]


def image(camera, centres, radii, **options):
    """The first sphere at each pixel of a Camera, certified: nearest(camera, None, ...).

    centres: (M, 3), radii: (M,) -> sphere, ties, s, s_error of shape (height, width), point.
    """
    return nearest(camera, None, centres, radii, **options)
