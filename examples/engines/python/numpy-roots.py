"""NumPy's roots() (Debian python3-numpy) for the textbook's rounded coefficients: eigenvalues of a companion matrix. "The values
in the rank-1 array p are coefficients of a polynomial"; returns complex roots, in no promised order; roots with the imaginary
part 0 are real. Source: its documentation string."""
import numpy

import raycheck_candidate as rc


def intersect(ray, sphere, _):
    (origin, d), (centre, r) = (tuple(map(numpy.array, ray)), sphere)
    f = origin - numpy.array(centre)
    s = numpy.roots([d @ d, 2 * (f @ d), f @ f - r * r])
    ahead = [] if s.imag.any() else s.real[s.real >= 0]
    return min(ahead, default=None)


rc.run("numpy", returns="parameter", root="nearest", tangent="either", level="ordinary", intersect=intersect)
