#include "properties/cases/varied_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "properties/mistakes/shown_picture.h"
#include "reference/exact_ray.h"
#include "scene/number.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

using scene::Scene;

constexpr std::uint64_t kSeeds = 200;
constexpr std::array kAll = {Variation::kScale, Variation::kSize, Variation::kSpheres};

/// The eye is off the origin; four spheres that are mirror images, two above and below, one that
/// hides one behind it.
Scene mirrored() {
  Scene result;
  scene::Camera& c = result.camera.emplace();
  c.eye = {1, 2, 3};
  c.look_at = {1, 2, 2};
  c.up = {0, 1, 0};
  c.near = -1;
  c.left = c.bottom = -1;
  c.right = c.top = 1;
  c.width = c.height = 21;
  for (const double x : {-2.0, 2.0}) {
    for (const double y : {-2.0, 2.0}) result.spheres.push_back({{1 + x, 2 + y, -2}, 0.75});
  }
  for (const double y : {-2.0, 2.0}) result.spheres.push_back({{1, 2 + y, -1}, 0.5});
  result.spheres.push_back({{1, 2, -2}, 0.5});
  result.spheres.push_back({{1, 2, -7}, 0.5});
  return result;
}

/// Four spheres in the corners, one in the middle of the left border, two more on it, two on the
/// top.
Scene bordered() {
  Scene result;
  scene::Camera& c = result.camera.emplace();
  c.look_at = {0, 0, -1};
  c.up = {0, 1, 0};
  c.near = -1;
  c.left = -1.75;
  c.right = 1.25;
  c.bottom = -1;
  c.top = 1.5;
  c.width = c.height = 13;
  for (const double x : {-17.5, 12.5}) {
    for (const double y : {-10.0, 15.0}) result.spheres.push_back({{x, y, -10}, 0.75});
  }
  result.spheres.push_back({{-17.5, 2.5, -10}, 0.75});
  for (const double y : {-3.75, 8.75}) result.spheres.push_back({{-17.5, y, -10}, 0.75});
  for (const double x : {-7.0, 2.0}) result.spheres.push_back({{x, 15, -10}, 0.75});
  return result;
}

TEST(VariedScene, FollowsFromItsSeedAndIsValid) {
  std::set<double> radii;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene one = varied_scene(mirrored(), kAll, seed);
    EXPECT_EQ(one, varied_scene(mirrored(), kAll, seed));
    EXPECT_TRUE(scene::defects(one).empty());
    radii.insert(one.spheres[0].radius / one.camera->near);
  }
  EXPECT_GE(radii.size(), kSeeds - 5);
}

TEST(VariedScene, IsAsItWasWhereNothingVaries) {
  EXPECT_EQ(varied_scene(bordered(), {}, 7), bordered());
}

TEST(VariedScene, KeepsMirrorImagesDepthsAndEqualSizes) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene one = varied_scene(mirrored(), kAll, seed);
    const scene::Camera& c = *one.camera;
    EXPECT_EQ(c.width, c.height);
    EXPECT_EQ((c.width - 21) % 2, 0);
    EXPECT_GE(c.width, 21);
    EXPECT_LE(c.width, 21 + kMostVariedPixels);
    const double scale = -c.near;
    const auto at = [&](std::size_t k) {
      const scene::Vector3 T = one.spheres[k].centre - c.eye;
      return scene::Vector3{T.x / scale, T.y / scale, T.z / scale};
    };
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(std::abs(at(k).x), std::abs(at(0).x), 1e-5);
      EXPECT_NEAR(std::abs(at(k).y), std::abs(at(0).y), 1e-5);
      EXPECT_EQ(at(k).x < 0, k < 2);
      EXPECT_EQ(at(k).y < 0, k % 2 == 0);
      EXPECT_EQ(one.spheres[k].radius, one.spheres[0].radius);
    }
    EXPECT_NEAR(at(4).y, -at(5).y, 1e-5);
    for (std::size_t k = 4; k < 8; ++k) EXPECT_NEAR(at(k).x, 0, 1e-12);
    const Scene was = mirrored();
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_NEAR(at(k).z, was.spheres[k].centre.z - 3, 1e-5);
      const double factor = one.spheres[k].radius / scale / was.spheres[k].radius;
      EXPECT_GE(factor, kLeastVariedFactor * (1 - 1e-5));
      EXPECT_LE(factor, kMostVariedFactor * (1 + 1e-5));
    }
  }
}

TEST(VariedScene, ShowsTheSameSpheresAndNoRayNearAnEdge) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene one = varied_scene(mirrored(), kAll, seed);
    std::set<std::size_t> seen;
    for (const auto& sphere : exact_image(one, one.conventions)) {
      if (sphere) seen.insert(*sphere);
    }
    for (const std::int64_t j : {0, 10, 20}) {
      for (std::int64_t i = 0; i < one.camera->width; ++i) {
        const reference::ExactRay ray(reference::ExactCamera(*one.camera, one.conventions), {i, j});
        for (const scene::Sphere& sphere : one.spheres) {
          const double half_chord_sq = ray.enclose(64).half_chord_sq(sphere).upper();
          EXPECT_GE(std::abs(half_chord_sq) / (sphere.radius * sphere.radius),
                    0.99 * kClearOfEdges);
        }
      }
    }
    EXPECT_EQ(seen, (std::set<std::size_t>{0, 1, 2, 3, 4, 5, 6})) << "the last is hidden";
  }
}

TEST(VariedScene, HasNumbersOfFewDigits) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const auto& [centre, radius] :
         varied_scene(mirrored(), std::array{Variation::kSpheres}, seed).spheres) {
      for (const double x : {centre.x, centre.y, centre.z, radius}) {
        EXPECT_LE(scene::shortest(x).size(), std::size_t{kVariedDigits + 3}) << x;
      }
    }
  }
}

TEST(VariedScene, MovesSpheresAlongTheBorderToRaysOfItsPixels) {
  std::set<double> left, top;
  constexpr std::array kBorder = {Variation::kSize, Variation::kBorder};
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene one = varied_scene(bordered(), kBorder, seed);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(one.spheres[k], bordered().spheres[k]);
    const auto gaps = static_cast<double>(one.camera->width - 1);
    const auto& at = one.spheres;
    EXPECT_EQ(at[5].centre.x, -17.5);
    EXPECT_EQ(at[7].centre.y, 15);
    EXPECT_NEAR(at[5].centre.y + at[6].centre.y, 5, 1e-4) << "mirror images";
    EXPECT_NEAR(at[7].centre.x + at[8].centre.x, -5, 1e-4) << "mirror images";
    const double row = (at[5].centre.y + 10) / 25 * gaps;
    const double column = (at[7].centre.x + 17.5) / 30 * gaps;
    for (const double pixel : {row, column}) {
      EXPECT_NEAR(pixel, std::round(pixel), 1e-4);
      EXPECT_GE(pixel, 0.9);
      EXPECT_LE(pixel, gaps / 2 + 0.1);
    }
    left.insert(row / gaps);
    top.insert(column / gaps);
  }
  EXPECT_GE(left.size(), 20u);
  EXPECT_GE(top.size(), 20u);
}

}  // namespace
}  // namespace raycheck::properties
