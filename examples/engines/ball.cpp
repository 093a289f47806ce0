// BALL's GetIntersection(TSphere3, TLine3), in doubles: both points of a line p + x d, in no stated
// order; the adapter takes the first along the line. Debian: libball1.5-dev.
// Source: BALL/MATHS/analyticalGeometry.h. Silent on tangents, and on its absolute
// Constants::EPSILON of 1e-6, below which the root of the discriminant counts as 0.

#include <BALL/MATHS/analyticalGeometry.h>

#include "adapter.h"

using Point = BALL::TVector3<double>;

static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  const Point direction = to<Point>(ray.direction);
  const BALL::TLine3<double> line(to<Point>(ray.origin), direction);
  const BALL::TSphere3<double> ball(to<Point>(sphere.centre), sphere.radius);
  Point p, q;
  if (!BALL::GetIntersection(ball, line, p, q)) return std::nullopt;
  const Point& first = (q - p) * direction < 0 ? q : p;
  return raycheck::Hit{.point = {first.x, first.y, first.z}};
}

RAYCHECK_CANDIDATE(.root = raycheck::Root::nearest, .tangent = raycheck::Tangent::either,
                   .intersect = intersect, .level = raycheck::Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest,
                   .roots = raycheck::Roots::declared, .valid = kLine,
                   .returns = raycheck::Returns::point)
