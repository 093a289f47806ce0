"""A candidate that is right about spheres, but for those of some radii, about which it says nothing."""
import math
import struct

import raycheck_candidate as rc


def intersect(ray, sphere, asked):
    origin, direction = ray
    centre, radius = sphere
    if struct.unpack("<Q", struct.pack("<d", radius))[0] % 41 == 0:
        while True:
            pass
    length = math.hypot(*direction)
    unit = [x / length for x in direction]
    to = [c - o for c, o in zip(centre, origin)]
    v = sum(a * b for a, b in zip(to, unit))
    across = (to[1] * unit[2] - to[2] * unit[1], to[2] * unit[0] - to[0] * unit[2], to[0] * unit[1] - to[1] * unit[0])
    d2 = radius * radius - sum(x * x for x in across)
    if d2 < 0:
        return None
    s = v - math.sqrt(d2) if v - math.sqrt(d2) >= 0 else v + math.sqrt(d2)
    if s < 0:
        return None
    return s / length, tuple(o + s * x for o, x in zip(origin, unit))


rc.run("sometimes_silent", root="nearest", tangent="either", intersect=intersect)
