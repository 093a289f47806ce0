#include "fast/intersect_formulas.h"

namespace raycheck::fast {

const IntersectMethod kSingleQuadratic = {
    .name = "single-quadratic",
    .sentence = "quadratic, everything in single precision",
    .intersect = intersect_batch<FromRoots<Textbook<float>>>,
    .intersect_one = intersect_one<FromRoots<Textbook<float>>>,
    .roots = roots_of<FromRoots<Textbook<float>>>,
    .max_ulp = kSingleQuadraticMaxUlp,
    .max_point_ulp = kSingleQuadraticMaxPointUlp,
    .not_kept =
        "spheres many radii away, grazing rays, origins near the surface or far from the world's",
    .domain = kSingleDomain,
    .unit_roundoff = 0x1p-24,
};

}  // namespace raycheck::fast
