#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {
namespace {

using Formula = HWY_NAMESPACE::Textbook<float>;

}  // namespace

/// `quadratic` in single precision; lengths are in kSingleDomain.
const IntersectMethod kSingleQuadratic = {
    .name = "single-quadratic",
    .sentence = "quadratic, everything in single precision",
    .intersect = HWY_NAMESPACE::intersect_batch<HWY_NAMESPACE::FromRoots<Formula>>,
    .intersect_one = HWY_NAMESPACE::intersect_one<HWY_NAMESPACE::FromRoots<Formula>>,
    .roots = HWY_NAMESPACE::roots_of<Formula>,
    .classes_in = HWY_NAMESPACE::classes_in<HWY_NAMESPACE::Textbook, float>,
    .max_ulp = 128 * 0x1p29,
    .max_point_ulp = 160 * 0x1p29,
    .not_kept =
        "spheres many radii away, grazing rays, origins near the surface or far from the world's",
    .domain = kSingleDomain,
    .unit_roundoff = 0x1p-24,
};

}  // namespace raycheck::fast
