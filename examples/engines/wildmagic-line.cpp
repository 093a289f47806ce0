// Wild Magic 5's IntrLine3Sphere3, in doubles: the first point of P + t D, t any real number, and
// its t; D must be unit. Debian: libwildmagic-dev; -lWm5Mathematics -lWm5Core.
// Source: libwildmagic/Wm5IntrLine3Sphere3.h, Wm5Line3.h. Silent on tangents, on the order of two
// points, and on the effect of Math::ZERO_TOLERANCE, 1e-8 (1e-6 in floats); the adapter's lengths
// are above it.

#include <libwildmagic/Wm5IntrLine3Sphere3.h>

#include "adapter.h"

using namespace raycheck;
using Wm5::Vector3d;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const Wm5::Line3d line(to<Vector3d>(ray.origin), to<Vector3d>(ray.direction));
  const Wm5::Sphere3d ball(to<Vector3d>(sphere.centre), sphere.radius);
  Wm5::IntrLine3Sphere3d both(line, ball);
  if (!both.Find() || both.GetQuantity() == 0) return std::nullopt;
  const Vector3d point = both.GetPoint(0);
  return Hit{both.GetLineParameter(0), {point.X(), point.Y(), point.Z()}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .roots = Roots::declared, .valid = kLine,
                   .directions = Directions::unit)
