#include "fast/intersect_formulas.h"

namespace raycheck::fast {

const IntersectMethod kLecture = {
    .name = "lecture",
    .sentence = "v = T.D, d^2 = r^2 - (|T|^2 - v^2), s = v - d",
    .intersect = intersect_batch<FromRoots<LectureFormula<double>>>,
    .intersect_one = intersect_one<FromRoots<LectureFormula<double>>>,
    .roots = roots_of<FromRoots<LectureFormula<double>>>,
    .max_ulp = kLectureMaxUlp,
    .max_point_ulp = kLectureMaxPointUlp,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
