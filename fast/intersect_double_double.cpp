#include "fast/double_double.h"
#include "fast/intersect_formulas.h"

namespace raycheck::fast {

const IntersectMethod kDoubleDouble = {
    .name = "double-double",
    .sentence = "disc = a r^2 - |T x d|^2 and roots by q, throughout in pairs of doubles",
    .intersect = intersect_batch<FromRoots<Lagrange<DoubleDouble>>>,
    .intersect_one = intersect_one<FromRoots<Lagrange<DoubleDouble>>>,
    .roots = roots_of<FromRoots<Lagrange<DoubleDouble>>>,
    .max_ulp = kDoubleDoubleMaxUlp,
    .max_point_ulp = kDoubleDoubleMaxPointUlp,
};

}  // namespace raycheck::fast
