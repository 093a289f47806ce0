#include "fast/intersect_batch.h"

namespace raycheck::fast {
namespace {

/// Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems (2019),
/// after Hearn and Baker: the distance from the centre to the line, instead of a difference of two
/// large squares.
struct Perpendicular {
  using Number = double;

  static RootsOf<double> roots(const Vector3d& origin, const Vector3d& direction,
                               const Vector3d& centre, double radius) {
    const Vector3d T = centre - origin;
    const double a = direction.dot(direction);
    const double b = T.dot(direction);
    const double c = T.dot(T) - radius * radius;
    const Vector3d off_line = T - (b / a) * direction;
    return roots_by_q<double>(a, b, c, a * (radius * radius - off_line.dot(off_line)));
  }
};

}  // namespace

const IntersectMethod kPerpendicular = {
    .name = "perpendicular",
    .sentence = "disc = a (r^2 - |T - (b/a) d|^2), roots by q",
    .intersect = intersect_batch<FromRoots<Perpendicular>>,
    .intersect_one = intersect_one<FromRoots<Perpendicular>>,
    .roots = roots_of<FromRoots<Perpendicular>>,
    .max_ulp = kPerpendicularMaxUlp,
    .max_point_ulp = kPerpendicularMaxPointUlp,
};

}  // namespace raycheck::fast
