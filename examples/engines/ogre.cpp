// Ogre's Math::intersects(Ray, Sphere), discardInside = false, in floats: whether it is a hit, and
// the t of Ray::getPoint(t). Debian: libogre-1.12-dev; -lOgreMain. With discardInside = true an
// origin inside is a hit at 0, which fits no root convention. Source: OGRE/OgreMath.h,
// OGRE/OgreRay.h. Silent on tangents and on whether roots behind the origin count, since it returns
// negative t (LINES selects the reading that they count). Directions of any length.

#include <OgreMath.h>
#include <OgreRay.h>
#include <OgreSphere.h>

#define SINGLE
#include "adapter.h"

using namespace raycheck;
using Ogre::Vector3;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const Ogre::Ray line(to<Vector3, float>(ray.origin), to<Vector3, float>(ray.direction));
  const Ogre::Sphere ball(to<Vector3, float>(sphere.centre), static_cast<float>(sphere.radius));
  const auto [hit, t] = Ogre::Math::intersects(line, ball, false);
  if (!hit) return std::nullopt;
  return Hit{t, {}};
}

#ifdef LINES
constexpr ValidRoots kValid = {.t_min = -std::numeric_limits<double>::infinity()};
#else
constexpr ValidRoots kValid = {};
#endif
RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision, .roots = Roots::declared,
                   .valid = kValid, .returns = Returns::parameter)
