# python3 case.py, with python3-poliastro
import numpy
from poliastro.core.events import line_of_sight
r1, d = numpy.array([{ox}, {oy}, {oz}]), numpy.array([{dx}, {dy}, {dz}])
print("miss" if line_of_sight.py_func(r1, r1 + d, {r}) >= 0 else "hit")
