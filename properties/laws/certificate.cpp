#include "properties/laws/certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "reference/interval_ray.h"

namespace raycheck::properties {

namespace {

/// A factor that outweighs the roundings of a few operations.
constexpr double kOfRoundings = 1 + 0x1p-40;

/// An upper bound, for these rays and spheres, of the factor by which plain_change() enlarges the
/// excused change.
double most_growth(const Candidate& candidate, const scene::Box<Ray>& rays,
                   const scene::Box<Sphere>& spheres) {
  if (candidate.level != Level::kOrdinary) return 1;
  std::array<double, 3> least = {}, most = {};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = std::array{&Point3::x, &Point3::y, &Point3::z}[k];
    const double from = spheres.least.centre.*axis - rays.greatest.origin.*axis;
    const double to = spheres.greatest.centre.*axis - rays.least.origin.*axis;
    least[k] = std::max({0.0, from, -to});
    most[k] = std::max(std::abs(from), std::abs(to));
  }
  const auto in_radii = [](const std::array<double, 3>& apart, double radius) {
    return std::hypot(apart[0], apart[1], apart[2]) / radius;
  };
  if (in_radii(least, spheres.greatest.radius) > kOrdinaryDistance * kOfRoundings) return 1;
  const double distance =
      std::min(in_radii(most, spheres.least.radius) * kOfRoundings, kOrdinaryDistance);
  return plain_growth(plain_change_at(distance)) * kOfRoundings;
}

}  // namespace

bool is_certain(const Law& law, const Candidate& candidate, const scene::Box<Case>& cases,
                DefectKind kind) {
  using reference::HitClass;
  const Scene &least = cases.least.scene, &greatest = cases.greatest.scene;
  const bool missed = kind.wrong == Wrong::kMissed;
  const bool is_class = judges_decisions(law) && law.quantity == kind.quantity &&
                        kind.quantity == Quantity::kClass &&
                        (missed || kind.wrong == Wrong::kFalseHit);
  const Conventions conventions = candidate.declared.over(least.conventions);
  // If both ends lie in the domain, all lengths between them do, except in ranges from 0 and except
  // distances.
  const bool has_points = std::any_of(least.spheres.begin(), least.spheres.end(),
                                      [](const Sphere& one) { return one.radius == 0; });
  if (!candidate.classes_in || !is_class || !conventions.valid.is_usual() || least.camera ||
      has_points) {
    return false;
  }
  const double change = excused_change(candidate.unit_roundoff);
  for (std::size_t k = 0; k < least.rays.size(); ++k) {
    const scene::Box<Ray> rays = {least.rays[k], greatest.rays[k]};
    for (std::size_t m = 0; m < least.spheres.size(); ++m) {
      const scene::Box<Sphere> spheres = {least.spheres[m], greatest.spheres[m]};
      const auto answers = candidate.classes_in(rays, spheres, conventions.hit_rule());
      if (missed ? answers.hit : answers.miss) continue;
      const auto truth = reference::intersection_in(
          rays, spheres, change * most_growth(candidate, rays, spheres), conventions.root);
      if (truth && truth->hit_class == (missed ? HitClass::kHit : HitClass::kMiss)) return true;
    }
  }
  return false;
}

}  // namespace raycheck::properties
