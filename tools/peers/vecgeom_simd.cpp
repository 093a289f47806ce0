#include "tools/peers/vecgeom_simd.h"

#include <VecGeom/volumes/OrbStruct.h>
#include <VecGeom/volumes/kernel/OrbImplementation.h>

#include <cstddef>

namespace raycheck::peers {

void distances_by_vecgeom(const fast::Rays& rays, const scene::Sphere& sphere,
                          std::span<double> parameters) {
  using Number = vecgeom::VectorBackend::Real_v;
  constexpr std::size_t kLanes = Number::size();
  const vecgeom::OrbStruct<double> orb(sphere.radius);
  const auto& [ox, oy, oz] = rays.origin;
  const auto& [dx, dy, dz] = rays.direction;
  const auto at = [](const auto& from, std::size_t k) { return Number(&from[k], Vc::Unaligned); };
  for (std::size_t k = 0; k + kLanes <= parameters.size(); k += kLanes) {
    const vecgeom::Vector3D<Number> origin(at(ox, k) - sphere.centre.x, at(oy, k) - sphere.centre.y,
                                           at(oz, k) - sphere.centre.z);
    const vecgeom::Vector3D<Number> direction(at(dx, k), at(dy, k), at(dz, k));
    Number s(0.0);
    vecgeom::OrbImplementation::DistanceToIn<Number>(orb, origin, direction,
                                                     Number(vecgeom::kInfLength), s);
    s.store(&parameters[k], Vc::Unaligned);
  }
}

}  // namespace raycheck::peers
