// VecGeom's UnplacedOrb, in doubles: DistanceToIn, and from inside DistanceToOut. Its Debian
// package is libvecgeom-dev, whose headers need the macro of the backend that it was built with:
// -DVECCORE_ENABLE_VC ... -lvecgeom.
//
// Source: VecGeom 1.2, VecGeom/volumes/UnplacedOrb.h and base/Global.h (kTolerance).

#include <VecGeom/volumes/UnplacedOrb.h>

#include "adapter.h"

using namespace raycheck;

static vecgeom::Vector3D<double> vector3(const Vector& v) { return {v.x, v.y, v.z}; }

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  // It speaks of orbs around the origin and of unit directions: whoever uses it sees to both.
  const auto origin = vector3(difference(ray.origin, sphere.centre));
  const double length = vector3(ray.direction).Mag();
  const auto unit = vector3(ray.direction) / length;
  const vecgeom::UnplacedOrb orb(sphere.radius);
  double distance = orb.DistanceToIn(origin, unit, vecgeom::kInfLength);
  // Negative: the origin is inside.
  if (distance < 0) distance = orb.DistanceToOut(origin, unit, vecgeom::kInfLength);
  if (!(distance >= 0 && distance < vecgeom::kInfLength)) return std::nullopt;
  return hit_at(ray, distance / length);
}

// Tangents count as hits and the first root from 0 on is taken, whatever is asked. Origins within
// 1e-9 of the surface are on it for VecGeom: below a thousandth that is most of a length.
RAYCHECK_CANDIDATE(.name = "vecgeom", .root = Root::nearest, .tangent = Tangent::hit,
                   .intersect = intersect, .level = Level::ordinary, .smallest_length = 0x1p-10,
                   .largest_length = 0x1p50)
