#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {

/// The formula of `double-double` in x87's format (significands of 64 bits). Domain: kWideDomain.
const IntersectMethod kLongDouble = {
    .name = "long-double",
    .sentence = "disc = a r^2 - |T x d|^2 and roots by q, in 64 bits (x87)",
    RAYCHECK_FUNCTIONS_RAY_BY_RAY(Lagrange<long double>),
    .max_ulp = 1,
    .max_point_ulp = 1.5,
    .domain = kWideDomain,
};

}  // namespace raycheck::fast
