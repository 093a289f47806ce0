#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {
namespace {

using Formula = HWY_NAMESPACE::Lagrange<long double>;

}  // namespace

const IntersectMethod kLongDouble = {
    .name = "long-double",
    .sentence = "disc = a r^2 - |T x d|^2 and roots by q, in 64 bits (x87)",
    .intersect = HWY_NAMESPACE::intersect_batch<HWY_NAMESPACE::FromRoots<Formula>>,
    .intersect_one = HWY_NAMESPACE::intersect_one<HWY_NAMESPACE::FromRoots<Formula>>,
    .roots = HWY_NAMESPACE::roots_of<Formula>,
    .max_ulp = kLongDoubleMaxUlp,
    .max_point_ulp = kLongDoubleMaxPointUlp,
    .domain = kWideDomain,
};

}  // namespace raycheck::fast
