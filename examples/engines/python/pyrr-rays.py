"""pyrr (Debian python3-pyrr), geometric_tests.ray_intersect_sphere: "Returns the intersection
points of a ray and a sphere", "Intersection points as a list of points", in no stated order; the
adapter returns the nearest. ray.create normalises the direction. Silent about tangents. Source:
pyrr/geometric_tests.py, pyrr/ray.py.
"""
import math

import pyrr

import raycheck_candidate as rc


def intersect(ray, sphere, _):
    origin, direction = ray
    centre, radius = sphere
    points = pyrr.geometric_tests.ray_intersect_sphere(
        pyrr.ray.create(list(origin), list(direction)), pyrr.sphere.create(list(centre), radius))
    return min(points, key=lambda point: math.dist(origin, point), default=None)


rc.run("pyrr", returns="point", root="nearest", tangent="either", level="ordinary", intersect=intersect)
