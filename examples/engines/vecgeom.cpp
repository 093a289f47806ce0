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
  // VecGeom knows orbs around the origin and unit directions: the caller converts.
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

// Tangents count as hits and the first root >= 0 is taken, whatever the conventions say. VecGeom
// takes origins within 1e-9 of the surface as on it: too coarse for lengths below 1e-3.
RAYCHECK_CANDIDATE(.name = "vecgeom", .root = Root::nearest, .tangent = Tangent::hit,
                   .intersect = intersect, .level = Level::ordinary, .smallest_length = 0x1p-10,
                   .largest_length = 0x1p50)
