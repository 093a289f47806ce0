#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {

/// `quadratic` in single precision. Domain: kSingleDomain.
const IntersectMethod kSingleQuadratic = {
    .name = "single-quadratic",
    .sentence = "quadratic, everything in single precision",
    RAYCHECK_FUNCTIONS_RAY_BY_RAY(Textbook<float>),
    .classes_in = HWY_NAMESPACE::classes_in<HWY_NAMESPACE::Textbook, float>,
    .max_ulp = 128 * 0x1p29,
    .max_point_ulp = 160 * 0x1p29,
    .not_kept =
        "spheres many radii away, grazing rays, origins near the surface or far from (0, 0, 0)",
    .domain = kSingleDomain,
    .unit_roundoff = 0x1p-24,
};

}  // namespace raycheck::fast
