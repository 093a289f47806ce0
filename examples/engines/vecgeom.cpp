// VecGeom's UnplacedOrb as a candidate, in doubles: DistanceToIn, and from inside DistanceToOut.
// Its Debian package is libvecgeom-dev, whose headers need the macro of the backend that it was
// built with; from the root of the sources
//
//     g++ -std=c++20 -O2 -fPIC -shared -Iinclude -DVECCORE_ENABLE_VC examples/engines/vecgeom.cpp
//         -lvecgeom -o vecgeom.so
//     raycheck properties --candidate library:vecgeom.so
//
// Source: VecGeom 1.2, VecGeom/volumes/UnplacedOrb.h and base/Global.h (kTolerance).

#include <VecGeom/volumes/UnplacedOrb.h>

#include <cmath>
#include <raycheck/candidate.hpp>

using namespace raycheck;

namespace {

using Vector3 = vecgeom::Vector3D<double>;

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  // It speaks of orbs around the origin and of unit directions: whoever uses it sees to both.
  const Vector3 origin(ray.origin.x - sphere.centre.x, ray.origin.y - sphere.centre.y,
                       ray.origin.z - sphere.centre.z);
  const Vector3 d(ray.direction.x, ray.direction.y, ray.direction.z);
  const double length = d.Mag();
  const Vector3 unit = d / length;
  const vecgeom::UnplacedOrb orb(sphere.radius);
  double distance = orb.DistanceToIn(origin, unit, vecgeom::kInfLength);
  // Negative: the origin is inside.
  if (distance < 0) distance = orb.DistanceToOut(origin, unit, vecgeom::kInfLength);
  if (!(distance >= 0 && distance < vecgeom::kInfLength)) return std::nullopt;
  const double s = distance / length;
  return Hit{s,
             {ray.origin.x + s * ray.direction.x, ray.origin.y + s * ray.direction.y,
              ray.origin.z + s * ray.direction.z}};
}

}  // namespace

// Tangents count as hits and the first root from 0 on is taken, whatever is asked. Origins within
// 1e-9 of the surface are on it for VecGeom: below a thousandth that is most of a length.
RAYCHECK_CANDIDATE(.name = "vecgeom", .root = Root::nearest, .tangent = Tangent::hit,
                   .intersect = intersect, .level = Level::ordinary, .smallest_length = 0x1p-10,
                   .largest_length = 0x1p50)
