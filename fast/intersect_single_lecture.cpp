#include "fast/intersect_formulas.h"

namespace raycheck::fast {

const IntersectMethod kSingleLecture = {
    .name = "single-lecture",
    .sentence = "lecture, everything in single precision",
    .intersect = intersect_batch<FromRoots<LectureFormula<float>>>,
    .intersect_one = intersect_one<FromRoots<LectureFormula<float>>>,
    .roots = roots_of<FromRoots<LectureFormula<float>>>,
    .max_ulp = kSingleLectureMaxUlp,
    .max_point_ulp = kSingleLectureMaxPointUlp,
    .not_kept =
        "spheres many radii away, grazing rays, origins near the surface or far from the world's",
    .domain = kSingleDomain,
    .unit_roundoff = 0x1p-24,
};

}  // namespace raycheck::fast
