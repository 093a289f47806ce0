#include "fast/internal/double_double.h"
#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {
namespace {

using Formula = HWY_NAMESPACE::Lagrange<DoubleDouble>;

}  // namespace

const IntersectMethod kDoubleDouble = {
    .name = "double-double",
    .sentence = "disc = a r^2 - |T x d|^2 and roots by q, throughout in pairs of doubles",
    .intersect = HWY_NAMESPACE::intersect_batch<HWY_NAMESPACE::FromRoots<Formula>>,
    .intersect_one = HWY_NAMESPACE::intersect_one<HWY_NAMESPACE::FromRoots<Formula>>,
    .roots = HWY_NAMESPACE::roots_of<Formula>,
    .max_ulp = kDoubleDoubleMaxUlp,
    .max_point_ulp = kDoubleDoubleMaxPointUlp,
};

}  // namespace raycheck::fast
