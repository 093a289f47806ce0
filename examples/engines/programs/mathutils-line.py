# blender --background --factory-startup --python {}
# Blender's mathutils.geometry.intersect_line_sphere, in floats, for lines: both points where the line through two points meets
# the sphere, in no stated order; the adapter takes the first along the line. Debian: blender. Source: its documentation string.
# Silent on tangents. Both points are given by raycheck (rays end).
# raycheck precision single
# raycheck lengths 1e-9 1e9
# raycheck rays end
# raycheck roots [] -inf inf absolute none
# raycheck returns point
# raycheck root nearest
# raycheck tangent either
# raycheck level ordinary
import sys

from mathutils import Vector
from mathutils.geometry import intersect_line_sphere

for line in sys.stdin:
    x = [float(word) for word in line.split()]
    start, end = Vector(x[:3]), Vector(x[3:6])
    points = intersect_line_sphere(start, end, Vector(x[6:9]), x[9], False) or ()
    first = min(filter(None, points), key=(end - start).dot, default=["miss"])
    print("=", *first, flush=True)
