// Imath's Sphere3::intersect in floats: "the point of intersection" at the smallest t >= 0 so that
// l(t) is a point on the sphere. Debian: libimath-dev. Source: Imath/ImathSphere.h. For what is
// undocumented see imath.cpp.

#include <Imath/ImathLine.h>
#include <Imath/ImathSphere.h>

#define SINGLE
#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  Imath::Line3f line;
  line.pos = to<Imath::V3f, float>(ray.origin);
  line.dir = to<Imath::V3f, float>(ray.direction);
  const Imath::Sphere3f ball(to<Imath::V3f, float>(sphere.centre),
                             static_cast<float>(sphere.radius));
  Imath::V3f point;
  if (!ball.intersect(line, point)) return std::nullopt;
  return Hit{.point = {point.x, point.y, point.z}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision,
                   .directions = Directions::unit, .returns = Returns::point)
