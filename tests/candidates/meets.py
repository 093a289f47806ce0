"""A candidate that meets rays with spheres and makes none: meets.py MISTAKE. MISTAKE may be far-root,
which takes the larger root always, or none."""
import sys

import raycheck_candidate as rc
import right


def intersect(ray, sphere, asked):
    if sys.argv[1] != "far-root":
        return right.intersect(ray, sphere, asked)
    (origin, d), (centre, r) = ray, sphere
    to = right.sub(centre, origin)
    a, b = right.dot(d, d), right.dot(to, d)
    moment = right.cross(to, d)
    discriminant = a * r * r - right.dot(moment, moment)
    if discriminant < 0 or (discriminant == 0 and asked.tangent == "miss"):
        return None
    s = (b + discriminant ** 0.5) / a
    return None if s < 0 else (s, right.add(origin, right.times(s, d)))


rc.run("meets", intersect=intersect)
