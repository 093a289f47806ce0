#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_quadratic.cpp"
#include <hwy/foreach_target.h>

#include "fast/internal/intersect_formulas.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
RAYCHECK_BATCH_OF(Textbook)
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
RAYCHECK_INTERSECT_BY(Textbook)

/// The general parametric approach as textbooks print it, b^2 - 4ac.
const IntersectMethod kQuadratic = {
    .name = "quadratic",
    .sentence = "s = (-b -+ sqrt(b^2 - 4ac)) / 2a, the textbook's general parametric approach",
    RAYCHECK_FUNCTIONS(Textbook),
    .classes_in = HWY_NAMESPACE::classes_in<HWY_NAMESPACE::Textbook>,
    .max_ulp = 128,
    .max_point_ulp = 160,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
#endif
