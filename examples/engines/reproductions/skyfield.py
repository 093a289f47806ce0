# python3 case.py, with python3-skyfield
import math
import numpy
from skyfield.geometry import intersect_line_and_sphere
centre = numpy.array([{cx}, {cy}, {cz}]) - numpy.array([{ox}, {oy}, {oz}])  # its lines start at (0, 0, 0)
near, far = intersect_line_and_sphere(numpy.array([{dx}, {dy}, {dz}]), centre, {r})
print("miss" if math.isnan(near) else near)
