#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {
namespace {

using Formula = HWY_NAMESPACE::Lagrange<long double>;

}  // namespace

/// `double-double` in the processor's 64 bits; lengths are in kWideDomain.
const IntersectMethod kLongDouble = {
    .name = "long-double",
    .sentence = "disc = a r^2 - |T x d|^2 and roots by q, in 64 bits (x87)",
    .intersect = HWY_NAMESPACE::intersect_batch<HWY_NAMESPACE::FromRoots<Formula>>,
    .intersect_one = HWY_NAMESPACE::intersect_one<HWY_NAMESPACE::FromRoots<Formula>>,
    .roots = HWY_NAMESPACE::roots_of<Formula>,
    .max_ulp = 1,
    .max_point_ulp = 1.5,
    .domain = kWideDomain,
};

}  // namespace raycheck::fast
