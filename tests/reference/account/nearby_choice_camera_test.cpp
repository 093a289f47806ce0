// Witnesses and refutations of wrong choices among spheres along a camera's rays.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "reference/account/nearby_choice.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using What = FirstMet::What;

/// So much larger than roundings that changed inputs may be rounded.
constexpr double kWide = 0x1p-26;

/// Spheres that all pass close by one point of the ray, or whose silhouettes pass close by it.
std::vector<scene::Sphere> spheres_near_a_point(Random& random, const ExactRay& ray) {
  const EnclosedRay enclosed = ray.enclose(128);
  const double s = random.between(0, 5);
  const auto along = [&](const Enclosure& from, const Enclosure& direction) {
    return from.upper() + s * direction.upper();
  };
  const Enclosure3 from = enclosed.origin();
  const Enclosure3 direction = enclosed.direction();
  const scene::Point3 met{along(from.x, direction.x), along(from.y, direction.y),
                          along(from.z, direction.z)};
  std::vector<scene::Sphere> spheres;
  while (spheres.size() < 3) {
    scene::Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const scene::Vector3 off = met - sphere.centre;
    const double impact_sq = sphere.radius * sphere.radius - enclosed.half_chord_sq(sphere).upper();
    sphere.radius =
        random.one_in(3) ? std::sqrt(std::max(0.0, impact_sq)) : std::hypot(off.x, off.y, off.z);
    sphere.radius *= 1 + random.between(-6, 6) * kWide;
    if (scene::defects(sphere).empty()) spheres.push_back(sphere);
  }
  return spheres;
}

bool is_right_of(const FirstMet& claim, const std::optional<NearestSphere>& nearest) {
  if (claim.what == What::kNothing) return !nearest;
  return nearest && (claim.what == What::kSomething || nearest->index == claim.sphere);
}

TEST(NearbyChoice, OfCamerasHoldsForCamerasSoChanged) {
  Random random(6);
  int witnesses = 0;
  int rounded_off = 0;
  int refutations = 0;
  int undecided = 0;
  for (int k = 0; k < 600; ++k) {
    const scene::Camera camera = random_camera(random, Sizes::kOrdinary);
    const scene::Conventions conventions = random_conventions(random);
    const scene::Pixel pixel = random_pixel(random, camera);
    const ExactRay ray(ExactCamera(camera, conventions), pixel);
    const std::vector<scene::Sphere> spheres = spheres_near_a_point(random, ray);
    const auto is_right_after = [&](const FirstMet& claim, const InputChange& change) {
      scene::Camera moved = camera;
      std::vector<scene::Sphere> seen = spheres;
      const auto inputs = inputs_of(moved, seen);
      for (std::size_t j = 0; j < change.size(); ++j) *inputs[j] *= 1 + change[j];
      const ExactRay changed(ExactCamera(moved, conventions), pixel);
      return is_right_of(claim, changed.nearest(seen, {}));
    };
    for (const FirstMet& claim : {FirstMet{What::kNothing}, FirstMet{What::kSomething},
                                  FirstMet{What::kSphere, 0}, FirstMet{What::kSphere, 1}}) {
      if (is_right_of(claim, ray.nearest(spheres, {}))) continue;
      const NearbyAnswer nearby = right_nearby(ray, spheres, {.relative_change = kWide}, claim);
      if (nearby.found == Nearby::kWitness) {
        ++witnesses;
        ASSERT_LE(nearby.witness.size(), 14 + 4 * spheres.size());
        for (const double share : nearby.witness) ASSERT_LE(std::abs(share), kWide);
        rounded_off += is_right_after(claim, nearby.witness) ? 0 : 1;
        continue;
      }
      ++(nearby.found == Nearby::kRefuted ? refutations : undecided);
      for (int corner = 0; corner < 6; ++corner) {
        InputChange change;
        for (int j = 0; j < 26; ++j) change.push_back(0.999 * kWide * random.sign());
        ASSERT_FALSE(is_right_after(claim, change)) << spelled(camera);
      }
    }
  }
  EXPECT_GE(witnesses, 200);
  EXPECT_GE(refutations, 200);
  EXPECT_EQ(undecided, 0);
  EXPECT_LE(rounded_off, witnesses / 100);
}

}  // namespace
}  // namespace raycheck::reference
