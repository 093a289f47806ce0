#include "fast/internal/intersect_formulas.h"

namespace raycheck::fast {
namespace {

using Formula = HWY_NAMESPACE::LectureFormula<float>;

}  // namespace

const IntersectMethod kSingleLecture = {
    .name = "single-lecture",
    .sentence = "lecture, everything in single precision",
    .intersect = HWY_NAMESPACE::intersect_batch<HWY_NAMESPACE::FromRoots<Formula>>,
    .intersect_one = HWY_NAMESPACE::intersect_one<HWY_NAMESPACE::FromRoots<Formula>>,
    .roots = HWY_NAMESPACE::roots_of<Formula>,
    .max_ulp = kSingleLectureMaxUlp,
    .max_point_ulp = kSingleLectureMaxPointUlp,
    .not_kept =
        "spheres many radii away, grazing rays, origins near the surface or far from the world's",
    .domain = kSingleDomain,
    .unit_roundoff = 0x1p-24,
};

}  // namespace raycheck::fast
