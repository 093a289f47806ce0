#include "fast/internal/double_double.h"
#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {

/// disc = |d|^2 r^2 - |T x d|^2 and roots by q, in pairs of doubles (about 106 bits).
const IntersectMethod kDoubleDouble = {
    .name = "double-double",
    .sentence = "disc = a r^2 - |T x D|^2 and roots by q, throughout in pairs of doubles",
    RAYCHECK_FUNCTIONS_RAY_BY_RAY(Lagrange<DoubleDouble>),
    .max_ulp = 1,
    .max_point_ulp = 1.5,
};

}  // namespace raycheck::fast
