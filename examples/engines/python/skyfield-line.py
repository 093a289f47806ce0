"""Skyfield (Debian python3-skyfield), geometry.intersect_line_and_sphere: "Given a line through the
origin (0,0,0) and an |xyz| endpoint, and a sphere [...], return the distance from the origin to
their two intersections"; two nan for a miss; "if the line is tangent to the sphere, the two
intersections will be at the same distance". It intersects lines, not rays; the adapter returns the
first distance, which may be negative. The line starts at (0,0,0), so that the adapter subtracts the
origin from the centre. Source: skyfield/geometry.py.
"""
import math

import numpy
from skyfield.geometry import intersect_line_and_sphere

import raycheck_candidate as rc


def intersect_batch(rays, sphere, _):
    centre, radius = sphere
    origins, directions = (numpy.array(part, dtype=float).T for part in zip(*rays))
    near, _ = intersect_line_and_sphere(directions, numpy.array(centre)[:, None] - origins, radius)
    return [None if math.isnan(distance) else distance for distance in near]


rc.run("skyfield", returns="distance", root="smaller", tangent="hit", level="ordinary",
       roots=rc.Roots("[]", -math.inf, math.inf, "absolute", "none"), intersect_batch=intersect_batch)
