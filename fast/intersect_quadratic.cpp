#include "fast/intersect_batch.h"

namespace raycheck::fast {
namespace {

struct Quadratic {
  static Roots roots(const Vector3d& origin, const Vector3d& direction, const Vector3d& centre,
                     double radius) {
    const Vector3d from_centre = origin - centre;
    const double a = direction.dot(direction);
    const double b = 2 * direction.dot(from_centre);
    const double c = from_centre.dot(from_centre) - radius * radius;
    const double discriminant = b * b - 4 * a * c;
    const double root = std::sqrt(discriminant);
    return {-b / (2 * std::sqrt(a)), discriminant / (4 * a), (-b - root) / (2 * a),
            (-b + root) / (2 * a)};
  }
};

}  // namespace

const IntersectMethod kQuadratic = {
    .name = "quadratic",
    .sentence = "t = (-b -+ sqrt(b^2 - 4ac)) / 2a, the textbook's general parametric approach",
    .intersect = intersect_batch<Quadratic>,
    .intersect_one = intersect_one<Quadratic>,
    .roots = roots_of<Quadratic>,
    .max_ulp = kQuadraticMaxUlp,
    .max_point_ulp = kQuadraticMaxUlp,
    .not_kept = "far spheres, grazing rays",
};

}  // namespace raycheck::fast
