// Witnesses and refutations of wrong answers about a camera's rays.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "reference/account/nearby_answer.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

/// The changes are so much larger than roundings that changed inputs may be rounded.
TEST(NearbyAnswer, OfCamerasHoldsForCamerasSoChanged) {
  constexpr double kWide = 0x1p-26;
  Random random(5);
  int witnesses = 0;
  int rounded_off = 0;
  int refutations = 0;
  for (int k = 0; k < 1500; ++k) {
    const scene::Camera camera = random_camera(random, Sizes::kOrdinary);
    const scene::Conventions conventions = random_conventions(random);
    const scene::Pixel pixel = random_pixel(random, camera);
    const ExactRay ray(ExactCamera(camera, conventions), pixel);
    scene::Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const auto enclosed = ray.enclose(128);
    const double impact_sq = sphere.radius * sphere.radius - enclosed.half_chord_sq(sphere).upper();
    sphere.radius = std::sqrt(std::max(0.0, impact_sq)) * (1 + random.between(-8, 8) * kWide);
    if (!scene::defects(sphere).empty()) continue;
    const bool misses = ray.intersect(sphere).hit_class == HitClass::kMiss;
    const auto answer =
        misses ? std::optional(std::abs(enclosed.axial_distance(sphere).upper())) : std::nullopt;
    const NearbyAnswer nearby = right_nearby(ray, sphere, {.relative_change = kWide}, answer);
    const auto is_right = [&](const std::vector<double>& change) {
      scene::Camera moved = camera;
      std::vector<scene::Sphere> seen = {sphere};
      const auto inputs = inputs_of(moved, seen);
      for (std::size_t j = 0; j < inputs.size(); ++j) *inputs[j] *= 1 + change[j];
      const ExactRay changed(ExactCamera(moved, conventions), pixel);
      return (changed.intersect(seen[0]).hit_class == HitClass::kMiss) != answer.has_value();
    };
    if (nearby.found == Nearby::kWitness) {
      ++witnesses;
      ASSERT_EQ(nearby.witness.size(), 18u);
      for (const double share : nearby.witness) ASSERT_LE(std::abs(share), kWide);
      rounded_off += is_right(nearby.witness) ? 0 : 1;
    }
    if (nearby.found != Nearby::kRefuted || answer) continue;
    ++refutations;
    for (int corner = 0; corner < 12; ++corner) {
      std::vector<double> change;
      for (int j = 0; j < 18; ++j) change.push_back(0.999 * kWide * random.sign());
      ASSERT_FALSE(is_right(change)) << spelled(camera) << spelled(sphere);
    }
  }
  EXPECT_GE(witnesses, 300);
  EXPECT_GE(refutations, 100);
  EXPECT_LE(rounded_off, witnesses / 100);
}

}  // namespace
}  // namespace raycheck::reference
