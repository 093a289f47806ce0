// Witnesses and refutations of wrong answers, and of wrong choices among spheres, along a camera's
// rays.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "reference/account/nearby_answer.h"
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

struct CameraRay {
  explicit CameraRay(Random& random)
      : camera(random_camera(random, Sizes::kOrdinary)),
        conventions(random_conventions(random)),
        pixel(random_pixel(random, camera)),
        ray(ExactCamera(camera, conventions), pixel) {}

  /// Whether a claim about rays and spheres is right at changed inputs.
  template <class Claim>
  bool is_right_after(const InputChange& change, std::vector<scene::Sphere> spheres,
                      const Claim& is_right) const {
    scene::Camera moved = camera;
    const auto inputs = inputs_of(moved, spheres);
    for (std::size_t j = 0; j < change.size(); ++j) *inputs[j] *= 1 + change[j];
    return is_right(ExactRay(ExactCamera(moved, conventions), pixel), spheres);
  }

  scene::Camera camera;
  scene::Conventions conventions;
  scene::Pixel pixel;
  ExactRay ray;
};

struct CameraCounts {
  int witnesses = 0, rounded_off = 0, refutations = 0, undecided = 0;
};

/// Holds what is found of a wrong claim against the claim at changed inputs: the witness, or
/// corners of the neighbourhood.
template <class Claim>
void expect_holds(Random& random, const CameraRay& one, const std::vector<scene::Sphere>& spheres,
                  const NearbyAnswer& nearby, const Claim& is_right, CameraCounts& counts) {
  const std::size_t inputs = 14 + 4 * spheres.size();
  if (nearby.found == Nearby::kWitness) {
    ++counts.witnesses;
    ASSERT_LE(nearby.witness.size(), inputs);
    for (const double share : nearby.witness) ASSERT_LE(std::abs(share), kWide);
    counts.rounded_off += one.is_right_after(nearby.witness, spheres, is_right) ? 0 : 1;
    return;
  }
  ++(nearby.found == Nearby::kRefuted ? counts.refutations : counts.undecided);
  if (nearby.found != Nearby::kRefuted) return;
  for (int corner = 0; corner < 6; ++corner) {
    InputChange change;
    for (std::size_t j = 0; j < inputs; ++j) change.push_back(0.999 * kWide * random.sign());
    ASSERT_FALSE(one.is_right_after(change, spheres, is_right)) << spelled(one.camera);
  }
}

TEST(NearbyAnswer, OfCamerasHoldsForCamerasSoChanged) {
  Random random(5);
  CameraCounts counts;
  for (int k = 0; k < 1500; ++k) {
    const CameraRay one(random);
    scene::Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const auto enclosed = one.ray.enclose(128);
    const double impact_sq = sphere.radius * sphere.radius - enclosed.half_chord_sq(sphere).upper();
    sphere.radius = std::sqrt(std::max(0.0, impact_sq)) * (1 + random.between(-8, 8) * kWide);
    if (!scene::defects(sphere).empty()) continue;
    const bool misses = one.ray.intersect(sphere).hit_class == HitClass::kMiss;
    const auto answer =
        misses ? std::optional(std::abs(enclosed.axial_distance(sphere).upper())) : std::nullopt;
    const NearbyAnswer nearby = right_nearby(one.ray, sphere, {.relative_change = kWide}, answer);
    // Of an s only the witness says whether it is right.
    if (answer && nearby.found != Nearby::kWitness) continue;
    expect_holds(
        random, one, {sphere}, nearby,
        [&](const ExactRay& ray, const std::vector<scene::Sphere>& seen) {
          return (ray.intersect(seen[0]).hit_class == HitClass::kMiss) != answer.has_value();
        },
        counts);
  }
  EXPECT_GE(counts.witnesses, 300);
  EXPECT_GE(counts.refutations, 100);
  EXPECT_LE(counts.rounded_off, counts.witnesses / 100);
}

TEST(NearbyChoice, OfCamerasHoldsForCamerasSoChanged) {
  Random random(6);
  CameraCounts counts;
  for (int k = 0; k < 600; ++k) {
    const CameraRay one(random);
    const std::vector<scene::Sphere> spheres = spheres_near_a_point(random, one.ray);
    for (const FirstMet& claim : {FirstMet{What::kNothing}, FirstMet{What::kSomething},
                                  FirstMet{What::kSphere, 0}, FirstMet{What::kSphere, 1}}) {
      if (is_right_of(claim, one.ray.nearest(spheres, {}))) continue;
      const NearbyAnswer nearby = right_nearby(one.ray, spheres, {.relative_change = kWide}, claim);
      expect_holds(
          random, one, spheres, nearby,
          [&](const ExactRay& ray, const std::vector<scene::Sphere>& seen) {
            return is_right_of(claim, ray.nearest(seen, {}));
          },
          counts);
    }
  }
  EXPECT_GE(counts.witnesses, 200);
  EXPECT_GE(counts.refutations, 200);
  EXPECT_EQ(counts.undecided, 0);
  EXPECT_LE(counts.rounded_off, counts.witnesses / 100);
}

}  // namespace
}  // namespace raycheck::reference
