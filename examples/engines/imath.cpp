// Imath's Sphere3::intersectT (in doubles; imath-float.cpp: in floats): the parameter of the line
// at "the smallest t >= 0 so that l(t) is a point on the sphere". Debian: libimath-dev. Source:
// Imath/ImathSphere.h, Imath/ImathLine.h. Both are silent on the direction's length. The adapter
// uses unit directions, since the functions that set a line from two points make them, and since
// this is the milder reading. Silent on tangents.

#include <Imath/ImathLine.h>
#include <Imath/ImathSphere.h>

#include "adapter.h"

using namespace raycheck;
using Vec = Imath::Vec3<Real>;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  Imath::Line3<Real> line;
  line.pos = to<Vec, Real>(ray.origin);
  line.dir = to<Vec, Real>(ray.direction);
  const Imath::Sphere3<Real> ball(to<Vec, Real>(sphere.centre), static_cast<Real>(sphere.radius));
  Real t = 0;
  if (!ball.intersectT(line, t)) return std::nullopt;
  return Hit{t, {}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision,
                   .directions = Directions::unit, .returns = Returns::parameter)
