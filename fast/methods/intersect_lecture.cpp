#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_lecture.cpp"
#include <hwy/foreach_target.h>

#include "fast/internal/intersect_formulas.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
RAYCHECK_BATCH_OF(LectureFormula)
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
RAYCHECK_INTERSECT_BY(LectureFormula)

/// The lecture's faster method: v = T.D, d^2 = r^2 - (|T|^2 - v^2), s = v - d.
const IntersectMethod kLecture = {
    .name = "lecture",
    .sentence = "v = T.D, d^2 = r^2 - (|T|^2 - v^2), s = v - d",
    RAYCHECK_FUNCTIONS(LectureFormula),
    .classes_in = HWY_NAMESPACE::classes_in<HWY_NAMESPACE::LectureFormula>,
    .max_ulp = 128,
    .max_point_ulp = 160,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
#endif
