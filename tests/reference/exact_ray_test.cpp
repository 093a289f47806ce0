#include "reference/exact_ray.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Conventions;
using scene::Ray;
using scene::Root;
using scene::Sphere;

const Ray kFromZero{{0, 0, 0}, {1, 0, 0}};

TEST(Nearest, IsEmptyWhenNothingIsMet) {
  const ExactRay ray(kFromZero);
  EXPECT_FALSE(ray.nearest({}, {}).has_value());
  const std::vector<Sphere> spheres{{{-5, 0, 0}, 1}, {{5, 5, 0}, 1}};
  EXPECT_FALSE(ray.nearest(spheres, {}).has_value());
}

TEST(Nearest, ReportsEveryTieAndTheFirstOfThem) {
  // All but the first two are met at s = 4; the fifth from inside.
  const std::vector<Sphere> spheres{{{9, 0, 0}, 1}, {{-3, 0, 0}, 1}, {{6, 0, 0}, 2}, {{5, 0, 0}, 1},
                                    {{0, 0, 0}, 4}, {{4, 3, 0}, 3},  {{8, 0, 0}, 4}};
  const auto nearest = ExactRay(kFromZero).nearest(spheres, {});
  ASSERT_TRUE(nearest.has_value());
  EXPECT_EQ(nearest->index, 2u);
  EXPECT_EQ(nearest->intersection, kSmallerHit);
  EXPECT_EQ(nearest->ties, (std::vector<std::size_t>{2, 3, 4, 5, 6}));
}

TEST(Nearest, FollowsTheConventions) {
  const std::vector<Sphere> spheres{{{0, 0, 0}, 3}, {{4, 2, 0}, 2}, {{9, 0, 0}, 1}};
  const ExactRay ray(kFromZero);
  Conventions conventions;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 0u);
  conventions.root = Root::kSmaller;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 1u);
  conventions.tangent = scene::Tangent::kEither;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 1u);
  conventions.tangent = scene::Tangent::kMiss;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 2u);
}

}  // namespace
}  // namespace raycheck::reference
