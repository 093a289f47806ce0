"""poliastro's line_of_sight (Debian python3-poliastro), in doubles: "Greater than or equal to zero, if there exists a LOS between
two objects located by r1 and r2, else negative", past a central attractor. The attractor is a solid ball about the origin; the
segment ends at the second object. Silent on tangents. Source: poliastro/core/events.py."""
import numpy
from poliastro.core.events import line_of_sight

import raycheck_candidate as rc


def intersect(ray, sphere, _):
    return not line_of_sight.py_func(*map(numpy.array, ray), sphere[1]) >= 0


rc.run("poliastro", returns="class", rays="end", t_max=1, placement="origin", from_inside="start", root="nearest",
       tangent="either", level="ordinary", intersect=intersect)
