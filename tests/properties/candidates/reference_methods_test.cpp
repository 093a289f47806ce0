// The reference as methods: right where they say so, and wrong where they say so.

#include "properties/candidates/reference_methods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "properties/quantity.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/exact_ray.h"
#include "tests/method_expectations.h"
#include "tests/method_names.h"
#include "tests/reference/random_cases.h"

namespace raycheck::properties {
namespace {

using reference::ExactRay;
using reference::HitClass;
using reference::Intersection;
using reference::Sizes;
using scene::Ray;
using scene::Root;
using scene::Sphere;
using scene::Tangent;

const Sphere kUnitSphere = {{0, 0, 0}, 1};

/// The digits of a certified error beyond a bound that the truth meets exactly: enclosures of
/// ExactRay::kValueBits leave so much.
constexpr double kCertifiedSlack = 0x1p-14;

class EachExactMethod : public testing::TestWithParam<const fast::IntersectMethod*> {};

TEST_P(EachExactMethod, FollowsTheConventions) {
  const auto meets = [&](const Ray& ray, Root root, Tangent tangent) {
    return GetParam()->intersect_one(ray, kUnitSphere, root, tangent).has_value();
  };
  const Ray inside = {{0, 0.5, 0}, {1, 0, 0}};
  EXPECT_TRUE(meets(inside, Root::kNearest, Tangent::kHit));
  EXPECT_FALSE(meets(inside, Root::kSmaller, Tangent::kHit));
  const Ray leaving = {{1, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(meets(leaving, Root::kNearest, Tangent::kHit));
  EXPECT_FALSE(meets(leaving, Root::kSmaller, Tangent::kHit));
  const Ray entering = {{-1, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(meets(entering, Root::kSmaller, Tangent::kHit));
  const Ray tangent = {{-5, 1, 0}, {1, 0, 0}};
  EXPECT_TRUE(meets(tangent, Root::kSmaller, Tangent::kEither));
  EXPECT_FALSE(meets(tangent, Root::kNearest, Tangent::kMiss));
  const Ray behind = {{5, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(meets(behind, Root::kNearest, Tangent::kHit));
}

TEST_P(EachExactMethod, AnswersOneRayAsItDoesABatch) {
  Random random(1);
  int hits = 0;
  for (int k = 0; k < 20; ++k) {
    std::vector<Ray> rays;
    for (int ray = 0; ray < 20; ++ray) {
      rays.push_back(reference::random_ray(random, Sizes::kOrdinary));
    }
    const Sphere sphere = {{random.between(-5, 5), random.between(-5, 5), 0}, 6};
    hits += expect_batch_is_single_calls(*GetParam(), rays, sphere, Root::kNearest, Tangent::kHit);
  }
  EXPECT_GT(hits, 100);
}

TEST_P(EachExactMethod, RefusesByTheNameOfTheField) { expect_refusals(*GetParam()); }

struct Mistaken {
  int hits = 0;
  int misses = 0;
  int wrong = 0;
  int parameters = 0;
};

/// Holds a method against its bound on s; wrong classes are counted.
Mistaken audit(const fast::IntersectMethod& method, Sizes sizes, int cases) {
  Mistaken counts;
  Random random(2);
  for (int k = 0; k < cases; ++k) {
    const Ray ray = reference::random_ray(random, sizes);
    const Sphere sphere = reference::random_sphere(random, sizes);
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere);
    const bool meets = at.hit_class != HitClass::kMiss;
    const auto answer = method.intersect_one(ray, sphere, Root::kNearest, Tangent::kHit);
    if (answer.has_value() != meets) {
      ++counts.wrong;
      continue;
    }
    (meets ? counts.hits : counts.misses) += 1;
    if (!meets || condition_of_parameter(exact, sphere, at) > kModerateCondition) continue;
    ++counts.parameters;
    EXPECT_LE(reference::ulp_error(answer->parameter, exact.parameter(sphere, at)),
              method.max_ulp + kCertifiedSlack)
        << method.name << reference::spelled(ray) << reference::spelled(sphere);
  }
  return counts;
}

TEST(ExactMethods, KeepTheirBoundsOnOrdinaryRays) {
  for (const auto* method : exact_methods()) {
    const Mistaken counts = audit(*method, Sizes::kOrdinary, 2000);
    EXPECT_EQ(counts.wrong, 0) << method->name;
    EXPECT_GT(counts.hits, 300) << method->name;
    EXPECT_GT(counts.misses, 300) << method->name;
    EXPECT_GT(counts.parameters, 150) << method->name;
  }
}

TEST(ExactMethods, KeepTheClassOfSmallIntegersTiesIncluded) {
  for (const auto* method : exact_methods()) {
    const Mistaken counts = audit(*method, Sizes::kSmallIntegers, 2000);
    EXPECT_EQ(counts.wrong, 0) << method->name;
    EXPECT_GT(counts.hits, 300) << method->name;
  }
}

TEST(ExactMethods, KeepTheClassOverTheWholeRangeWhereTheyPromiseTo) {
  int promised = 0;
  for (const auto* method : exact_methods()) {
    if (!method->exact_class) continue;
    ++promised;
    int hits = 0;
    Random random(3);
    for (int k = 0; k < 1000; ++k) {
      const Ray ray = reference::random_ray(random, Sizes::kAll);
      const Sphere sphere = reference::random_sphere(random, Sizes::kAll);
      const bool meets = ExactRay(ray)
                             .intersect(sphere, Root::kNearest, reference::Engine::kFieldOnly)
                             .hit_class != HitClass::kMiss;
      hits += meets ? 1 : 0;
      EXPECT_EQ(method->intersect_one(ray, sphere, Root::kNearest, Tangent::kHit).has_value(),
                meets)
          << method->name << reference::spelled(ray) << reference::spelled(sphere);
    }
    EXPECT_GT(hits, 50);
  }
  EXPECT_EQ(promised, 2);
}

bool meets(const fast::IntersectMethod& method, double y, double z) {
  return method.intersect_one({{-5, y, z}, {1, 0, 0}}, kUnitSphere, Root::kNearest, Tangent::kHit)
      .has_value();
}

TEST(Arb128, DoesNotTellWhat128BitsDoNot) {
  // y^2 + z^2 exceeds 1 by 2^-140.
  EXPECT_TRUE(meets(kArb, 1, 0x1p-70));
  EXPECT_FALSE(meets(kReference, 1, 0x1p-70));
  EXPECT_FALSE(meets(kArb, 1, 0x1p-60));
}

TEST(ReferenceIntervals, MissesWhatItDoesNotDecide) {
  // y^2 + z^2 is 1 - 2^-52 + 2^-54 + 2^-106.
  EXPECT_TRUE(meets(kReference, 1 - 0x1p-53, 0x1p-27));
  EXPECT_FALSE(meets(kReferenceIntervals, 1 - 0x1p-53, 0x1p-27));
}

INSTANTIATE_TEST_SUITE_P(Methods, EachExactMethod,
                         testing::ValuesIn(exact_methods().begin(), exact_methods().end()),
                         fast::test_name);

}  // namespace
}  // namespace raycheck::properties
