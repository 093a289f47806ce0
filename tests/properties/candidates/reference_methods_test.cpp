// The methods made of the reference keep their promises, and fail at their documented limits.

#include "properties/candidates/reference_methods.h"

#include "properties/candidates/fast_candidate.h"
#include "properties/search/campaign.h"
#include "reference/exact_ray.h"
#include "tests/method_names.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using reference::Sizes;
using scene::Ray;
using scene::Root;
using scene::Sphere;
using scene::Tangent;

const Sphere kUnitSphere = {{0, 0, 0}, 1};

/// If the true error equals a bound, the certified error exceeds the bound by at most this: the
/// width of enclosures of ExactRay::kValueBits.
constexpr double kCertifiedSlack = 0x1p-14;

class EachExactMethod : public testing::TestWithParam<const fast::IntersectMethod*> {};

/// Each method keeps them under every convention, and within its bound on s.
TEST_P(EachExactMethod, KeepsTheLawsOnOrdinaryCases) {
  Candidate candidate = fast_candidate(fast::kDirectRays, *GetParam());
  auto& bound = candidate.max_error[static_cast<std::size_t>(Quantity::kParameter)];
  bound = bound.value() + kCertifiedSlack;
  CampaignOptions options;
  options.cases = 900;
  for (const char* law : {"class", "nearest-root", "parameter"}) {
    EXPECT_EQ(run_campaign(*find_law(law), candidate, options).finding(), Finding::kHolds) << law;
  }
}

/// On small integers, including ties; if the method promises it, over the whole range of doubles.
TEST_P(EachExactMethod, KeepsTheClass) {
  for (const Sizes sizes : {Sizes::kSmallIntegers, Sizes::kAll}) {
    if (sizes == Sizes::kAll && !GetParam()->exact_class) continue;
    int hits = 0;
    Random random(3);
    for (int k = 0; k < 1000; ++k) {
      const Ray ray = reference::random_ray(random, sizes);
      const Sphere sphere = reference::random_sphere(random, sizes);
      const bool meets = reference::ExactRay(ray)
                             .intersect(sphere, Root::kNearest, {reference::Engine::kFieldOnly})
                             .hit_class != reference::HitClass::kMiss;
      hits += meets ? 1 : 0;
      EXPECT_EQ(GetParam()->intersect_one(ray, sphere, {}).has_value(), meets)
          << reference::spelled(ray) << reference::spelled(sphere);
    }
    EXPECT_GT(hits, 50);
  }
}

TEST(ExactMethods, PromiseTheClassTwice) {
  EXPECT_EQ(std::count_if(exact_methods().begin(), exact_methods().end(),
                          [](const auto* method) { return method->exact_class; }),
            2);
}

bool meets(const fast::IntersectMethod& method, double y, double z) {
  return method.intersect_one({{-5, y, z}, {1, 0, 0}}, kUnitSphere, {}).has_value();
}

TEST(Arb128, DoesNotResolveDifferencesBelow128Bits) {
  // y^2 + z^2 exceeds 1 by 2^-140.
  EXPECT_TRUE(meets(kArb, 1, 0x1p-70));
  EXPECT_FALSE(meets(kReference, 1, 0x1p-70));
  EXPECT_FALSE(meets(kArb, 1, 0x1p-60));
}

TEST(ReferenceIntervals, AnswersAMissIfItIsUndecided) {
  // y^2 + z^2 is 1 - 2^-52 + 2^-54 + 2^-106.
  EXPECT_TRUE(meets(kReference, 1 - 0x1p-53, 0x1p-27));
  EXPECT_FALSE(meets(kReferenceIntervals, 1 - 0x1p-53, 0x1p-27));
}

INSTANTIATE_TEST_SUITE_P(Methods, EachExactMethod,
                         testing::ValuesIn(exact_methods().begin(), exact_methods().end()),
                         fast::test_name);

}  // namespace
}  // namespace raycheck::properties
