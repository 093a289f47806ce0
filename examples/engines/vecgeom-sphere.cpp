// VecGeom's UnplacedSphere without an inner radius, in doubles. DistanceToOut is called for origins
// inside, DistanceToIn for all others, since it is undefined inside. Debian: libvecgeom-dev, whose
// headers need the macro of the backend that it was built with: -DVECCORE_ENABLE_VC ... -lvecgeom.
// Source: VecGeom/volumes/UnplacedSphere.h, UnplacedVolume.h (unit directions), base/Global.h.
// Points within kTolerance = 1e-9 of the surface count as on it, which is too coarse for lengths
// below 1e-3. Its spheres have their centres at (0, 0, 0), so that the adapter subtracts the
// centre.

#include <VecGeom/volumes/UnplacedSphere.h>

#include "adapter.h"

using namespace raycheck;
using Vec = vecgeom::Vector3D<double>;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const auto origin = to<Vec>(ray.origin) - to<Vec>(sphere.centre), unit = to<Vec>(ray.direction);
  const vecgeom::UnplacedSphere ball(0, sphere.radius);
  const double distance = ball.Inside(origin) == vecgeom::kInside
                              ? ball.DistanceToOut(origin, unit, vecgeom::kInfLength)
                              : ball.DistanceToIn(origin, unit, vecgeom::kInfLength);
  if (!(distance >= 0 && distance < vecgeom::kInfLength)) return std::nullopt;
  return Hit{distance, {}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = 0x1p-10, .largest_length = 0x1p50,
                   .directions = Directions::unit, .returns = Returns::distance)
