#include "fast/intersect_batch.h"

namespace raycheck::fast {
namespace {

struct StableQuadratic {
  using Number = double;

  static RootsOf<double> roots(const Vector3d& origin, const Vector3d& direction,
                               const Vector3d& centre, double radius) {
    const Vector3d T = centre - origin;
    const double a = direction.dot(direction);
    const double b = T.dot(direction);
    const double c = T.dot(T) - radius * radius;
    return roots_by_q<double>(a, b, c, b * b - a * c);
  }
};

}  // namespace

const IntersectMethod kStableQuadratic = {
    .name = "stable-quadratic",
    .sentence = "disc = b^2 - ac, q = b + sign(b) sqrt(disc), roots q/a and c/q",
    .intersect = intersect_batch<FromRoots<StableQuadratic>>,
    .intersect_one = intersect_one<FromRoots<StableQuadratic>>,
    .roots = roots_of<FromRoots<StableQuadratic>>,
    .max_ulp = kStableQuadraticMaxUlp,
    .max_point_ulp = kStableQuadraticMaxPointUlp,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
