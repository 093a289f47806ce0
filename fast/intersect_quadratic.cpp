#include "fast/intersect_formulas.h"

namespace raycheck::fast {

const IntersectMethod kQuadratic = {
    .name = "quadratic",
    .sentence = "t = (-b -+ sqrt(b^2 - 4ac)) / 2a, the textbook's general parametric approach",
    .intersect = intersect_batch<FromRoots<Textbook<double>>>,
    .intersect_one = intersect_one<FromRoots<Textbook<double>>>,
    .roots = roots_of<FromRoots<Textbook<double>>>,
    .max_ulp = kQuadraticMaxUlp,
    .max_point_ulp = kQuadraticMaxPointUlp,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
