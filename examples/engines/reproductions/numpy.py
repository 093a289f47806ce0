# python3 case.py, with python3-numpy
import numpy
f = numpy.array([{ox}, {oy}, {oz}]) - numpy.array([{cx}, {cy}, {cz}])
d, r = numpy.array([{dx}, {dy}, {dz}]), {r}
s = numpy.roots([d @ d, 2 * (f @ d), f @ f - r * r])
print(min(s.real[s.real >= 0]) if not s.imag.any() and any(s.real >= 0) else "miss")
