// Wild Magic 5's IntrRay3Sphere3 (in doubles; wildmagic-ray-float.cpp: in floats): the first point
// of P + t D, t >= 0, and its t; D must be unit. Debian: libwildmagic-dev; -lWm5Mathematics
// -lWm5Core.
// Source: libwildmagic/Wm5IntrRay3Sphere3.h, Wm5Ray3.h. Silent on tangents, on the order of two
// points, and on the effect of Math::ZERO_TOLERANCE, 1e-8 (1e-6 in floats); the adapter's lengths
// are above it.

#include <libwildmagic/Wm5IntrRay3Sphere3.h>

#include "adapter.h"

using namespace raycheck;
using Vec = Wm5::Vector3<Real>;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const Wm5::Ray3<Real> line(to<Vec, Real>(ray.origin), to<Vec, Real>(ray.direction));
  const Wm5::Sphere3<Real> ball(to<Vec, Real>(sphere.centre), static_cast<Real>(sphere.radius));
  Wm5::IntrRay3Sphere3<Real> both(line, ball);
  if (!both.Find() || both.GetQuantity() == 0) return std::nullopt;
  const Vec point = both.GetPoint(0);
  return Hit{both.GetRayParameter(0), {point.X(), point.Y(), point.Z()}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision,
                   .directions = Directions::unit)
