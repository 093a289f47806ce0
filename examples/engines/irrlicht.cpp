// Irrlicht's line3d::getIntersectionWithSphere (in doubles; irrlicht-float.cpp: in floats): "the
// distance to the first intersection point" from the line's start. Debian: libirrlicht-dev.
// Source: irrlicht/line3d.h. A line is given by two points, here the origin and
// origin + kFar direction. Tangents are not mentioned, nor whether the line ends at these points
// (it does not).

#include <irrlicht/line3d.h>

#include "adapter.h"

using namespace raycheck;
using Point = irr::core::vector3d<Real>;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const auto start = to<Point, Real>(ray.origin);
  const irr::core::line3d<Real> line(start, start + to<Point, Real>(ray.direction) * kFar);
  double distance = 0;
  if (!line.getIntersectionWithSphere(to<Point, Real>(sphere.centre),
                                      static_cast<Real>(sphere.radius), distance)) {
    return std::nullopt;
  }
  return Hit{distance, {}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision, .roots = Roots::declared,
                   .valid = kLine, .returns = Returns::distance)
