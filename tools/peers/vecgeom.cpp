#include <VecGeom/volumes/UnplacedOrb.h>

#include "fast/ray_by_ray.h"
#include "tools/peers/peers.h"

namespace raycheck::peers {
namespace {

using Vector = vecgeom::Vector3D<double>;

struct Vecgeom {
  explicit Vecgeom(const scene::Sphere& sphere) : centre(sphere.centre), orb(sphere.radius) {}

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::Root /*root*/,
                                  scene::Tangent /*tangent*/) const {
    const scene::Vector3 from_centre = ray.origin - centre;
    const Vector origin(from_centre.x, from_centre.y, from_centre.z);
    const Vector direction(ray.direction.x, ray.direction.y, ray.direction.z);
    double s = orb.DistanceToIn(origin, direction, vecgeom::kInfLength);
    // Negative: the origin is inside.
    if (s < 0) s = orb.DistanceToOut(origin, direction, vecgeom::kInfLength);
    if (!(s >= 0 && s < vecgeom::kInfLength)) return std::nullopt;
    return fast::hit_at(ray, s);
  }

  scene::Point3 centre;
  vecgeom::UnplacedOrb orb;
};

/// Its tolerance is the absolute 1e-9: an origin that is nearer to the surface is on it.
constexpr double kSmallestLength = 0x1p-10;

}  // namespace

extern const fast::IntersectMethod kVecgeom = {
    .name = "vecgeom",
    .sentence = "VecGeom's UnplacedOrb: DistanceToIn, from inside DistanceToOut",
    .intersect = fast::intersect_ray_by_ray<Vecgeom>,
    .intersect_one = fast::intersect_one_ray<Vecgeom>,
    .max_ulp = kSquaresMaxUlp,
    .max_point_ulp = kSquaresMaxUlp,
    .not_kept = "far spheres, grazing rays, origins within 1e-9 of the surface",
    .domain = {.smallest_length = kSmallestLength},
    .contract = {.unit_direction = true,
                 .root = scene::Root::kNearest,
                 .tangent = scene::Tangent::kHit},
};

}  // namespace raycheck::peers
