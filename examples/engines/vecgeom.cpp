// VecGeom's UnplacedOrb, in doubles: DistanceToIn; if it is negative, the origin is inside, and
// DistanceToOut is called. Debian: libvecgeom-dev, whose headers need the macro of the backend that
// it was built with: -DVECCORE_ENABLE_VC ... -lvecgeom. Source: VecGeom/volumes/UnplacedOrb.h,
// UnplacedVolume.h (unit directions), base/Global.h. Points within kTolerance = 1e-9 of the surface
// count as on it, which is too coarse for lengths below 1e-3. Its orbs have their centres at (0, 0,
// 0), so that the adapter subtracts the centre.

#include <VecGeom/volumes/UnplacedOrb.h>

#include "adapter.h"

using namespace raycheck;
using Vec = vecgeom::Vector3D<double>;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const auto origin = to<Vec>(ray.origin) - to<Vec>(sphere.centre), unit = to<Vec>(ray.direction);
  const vecgeom::UnplacedOrb orb(sphere.radius);
  double distance = orb.DistanceToIn(origin, unit, vecgeom::kInfLength);
  if (distance < 0) distance = orb.DistanceToOut(origin, unit, vecgeom::kInfLength);
  if (!(distance >= 0 && distance < vecgeom::kInfLength)) return std::nullopt;
  return Hit{distance, {}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = 0x1p-10, .largest_length = 0x1p50,
                   .directions = Directions::unit, .returns = Returns::distance)
