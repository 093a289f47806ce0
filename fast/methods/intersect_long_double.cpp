#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {

/// The formula of `double-double` in the processor's 80-bit format (x87). Domain: kWideDomain.
const IntersectMethod kLongDouble = {
    .name = "long-double",
    .sentence = "disc = a r^2 - |T x D|^2 and roots by q, with 64-bit significands (x87)",
    RAYCHECK_FUNCTIONS_RAY_BY_RAY(Lagrange<long double>),
    .max_ulp = 1,
    .max_point_ulp = 1.5,
    .domain = kWideDomain,
};

}  // namespace raycheck::fast
