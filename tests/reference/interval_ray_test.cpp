// What boxes of rays and spheres have in common, against single ones in them.

#include "reference/interval_ray.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Box;
using scene::Ray;
using scene::Root;
using scene::Sphere;

constexpr double kBoxChange = 0x1p-20;

struct BoxCounts {
  int hits = 0, misses = 0, open = 0, contradicted = 0;
};

/// Boxes of spheres that the ray about grazes, and questions in them whose numbers are changed by
/// up to `change`.
BoxCounts box_counts(double change) {
  Random random(11);
  BoxCounts all;
  for (int k = 0; k < 3000; ++k) {
    const Root root = random.one_in(2) ? Root::kNearest : Root::kSmaller;
    const double along = random.between(-4, 9);
    const Ray ray = {{0.5, 0.25, -2}, {0, 0, random.power_of_ten(-2, 2)}};
    const double across = random.power_of_ten(-1, 1);
    const Sphere least = {{0.5 + across, 0.25, along},
                          across * (1 + random.between(-8, 8) * kBoxChange)};
    Sphere greatest = least;
    greatest.radius *= 1 + random.between(0, 4) * kBoxChange;
    const auto common = intersection_in({ray, ray}, {least, greatest}, kBoxChange, root);
    if (!common) {
      ++all.open;
      continue;
    }
    (common->hit_class == HitClass::kMiss ? all.misses : all.hits) += 1;
    bool contradicted = false;
    for (int sample = 0; sample < 12; ++sample) {
      Ray one = ray;
      Sphere sphere = least;
      sphere.radius = sample % 2 == 0 ? least.radius : greatest.radius;
      for (double* x : {&one.origin.x, &one.origin.y, &one.origin.z, &one.direction.z,
                        &sphere.centre.x, &sphere.centre.y, &sphere.centre.z, &sphere.radius}) {
        *x *= 1 + random.sign() * change;
      }
      contradicted |= ExactRay(one).intersect(sphere, root) != *common;
    }
    all.contradicted += contradicted ? 1 : 0;
  }
  return all;
}

TEST(IntersectionInBoxes, IsThatOfAllInThemAndOfAllCloseBy) {
  const BoxCounts within = box_counts(kBoxChange * (1 - 0x1p-30));
  EXPECT_EQ(within.contradicted, 0);
  EXPECT_GT(within.hits, 200);
  EXPECT_GT(within.misses, 200);
  EXPECT_GT(within.open, 200);
}

TEST(IntersectionInBoxes, IsNotThatOfOnesFartherOff) {
  EXPECT_GT(box_counts(4 * kBoxChange).contradicted, 20);
}

TEST(IntersectionInBoxes, IsTheExactOneOfASingleRayThatPassesClearly) {
  Random random(5);
  int decided = 0;
  for (int k = 0; k < 2000; ++k) {
    const Ray ray = random_ray(random, Sizes::kOrdinary);
    const Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const auto found = intersection_in({ray, ray}, {sphere, sphere}, 0, Root::kNearest);
    if (!found) continue;
    ++decided;
    EXPECT_EQ(*found, ExactRay(ray).intersect(sphere));
  }
  EXPECT_GT(decided, 1900);
}

TEST(IntersectionInBoxes, RefusesWhatIsNoProblem) {
  const Ray ray = {{0, 0, 0}, {0, 0, 1}};
  const Ray none = {{0, 0, 0}, {0, 0, 0}};
  EXPECT_THROW(intersection_in({none, ray}, {kUnit, kUnit}, 0, {}), std::invalid_argument);
  EXPECT_THROW(intersection_in({ray, none}, {kUnit, kUnit}, 0, {}), std::invalid_argument);
  EXPECT_THROW(intersection_in({ray, ray}, {{{}, -1}, kUnit}, 0, {}), std::invalid_argument);
}

}  // namespace
}  // namespace raycheck::reference
