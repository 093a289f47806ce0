#include "fast/intersect_batch.h"

namespace raycheck::fast {
namespace {

struct Lecture {
  static Roots roots(const Vector3d& origin, const Vector3d& direction, const Vector3d& centre,
                     double radius) {
    const double length = direction.norm();
    const Vector3d U = direction / length;
    const Vector3d T = centre - origin;
    const double v = T.dot(U);
    const double half_chord_sq = radius * radius - (T.dot(T) - v * v);
    const double half_chord = std::sqrt(half_chord_sq);
    return {v, half_chord_sq, (v - half_chord) / length, (v + half_chord) / length};
  }
};

}  // namespace

const IntersectMethod kLecture = {
    .name = "lecture",
    .sentence = "v = T.D, d^2 = r^2 - (|T|^2 - v^2), s = v - d",
    .intersect = intersect_batch<Lecture>,
    .intersect_one = intersect_one<Lecture>,
    .roots = roots_of<Lecture>,
    .max_ulp = kLectureMaxUlp,
    .max_point_ulp = kLectureMaxUlp,
    .not_kept = "far spheres, grazing rays",
};

}  // namespace raycheck::fast
