// Avogadro's Rendering::SphereGeometry::hits, in floats: the spheres that are hit by the ray from
// an origin to an end, with its unit direction. The depths that it returns, too, are not
// documented. Debian: libavogadro-dev; -lAvogadroRendering -lAvogadroCore. Source:
// avogadro/rendering/spheregeometry.h. Silent on tangents. Its rays end far behind all spheres.

#include <avogadro/rendering/spheregeometry.h>

#define SINGLE
#include "adapter.h"

using Avogadro::Vector3f;

static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  Avogadro::Rendering::SphereGeometry spheres;
  spheres.identifier().type = Avogadro::Rendering::AtomType;
  spheres.addSphere(to<Vector3f, float>(sphere.centre), {}, static_cast<float>(sphere.radius));
  const Vector3f origin = to<Vector3f, float>(ray.origin);
  const Vector3f direction = to<Vector3f, float>(ray.direction);
  if (spheres.hits(origin, origin + static_cast<float>(kFar) * direction, direction).empty()) {
    return std::nullopt;
  }
  return raycheck::Hit{};
}

RAYCHECK_CANDIDATE(.root = raycheck::Root::nearest, .tangent = raycheck::Tangent::either,
                   .intersect = intersect, .level = raycheck::Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest,
                   .precision = kPrecision, .directions = raycheck::Directions::unit,
                   .returns = raycheck::Returns::class_only)
