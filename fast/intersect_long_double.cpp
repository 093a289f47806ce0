#include "fast/intersect_formulas.h"

namespace raycheck::fast {

const IntersectMethod kLongDouble = {
    .name = "long-double",
    .sentence = "disc = a r^2 - |T x d|^2 and roots by q, in 64 bits (x87)",
    .intersect = intersect_batch<FromRoots<Lagrange<long double>>>,
    .intersect_one = intersect_one<FromRoots<Lagrange<long double>>>,
    .roots = roots_of<FromRoots<Lagrange<long double>>>,
    .max_ulp = kLongDoubleMaxUlp,
    .max_point_ulp = kLongDoubleMaxPointUlp,
    .domain = kWideDomain,
};

}  // namespace raycheck::fast
