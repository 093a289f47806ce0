// Methods of other libraries: right inside their contracts, and the contracts are needed.

#include "tools/peers/peers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "properties/cases/random.h"
#include "properties/quantity.h"
#include "reference/account/condition.h"
#include "reference/account/nearby_answer.h"
#include "reference/error_measure.h"
#include "reference/exact_ray.h"
#include "tests/method_expectations.h"
#include "tests/method_names.h"

namespace raycheck::peers {
namespace {

using properties::Random;
using reference::ExactRay;
using reference::HitClass;
using reference::Intersection;
using scene::Ray;
using scene::Root;
using scene::Sphere;
using scene::Tangent;

const Sphere kUnitSphere = {{0, 0, 0}, 1};

/// A ray with a unit direction and a sphere in reach of the bounds: most are met, some from inside
/// unless the contract forbids it.
struct Pair {
  Ray ray;
  Sphere sphere;
};
Pair random_pair(Random& random, const fast::Contract& contract) {
  for (;;) {
    const scene::Vector3 centre = random.in_cube(10);
    const scene::Vector3 away = random.direction();
    const scene::Vector3 aside = random.direction();
    const double radius = random.between(0.5, 5);
    const double distance = radius * random.between(0, kNearbyRadii);
    const double miss_by = radius * random.between(0, 1.5);
    if (contract.origin_outside && distance <= radius) continue;
    const Sphere sphere = {{centre.x, centre.y, centre.z}, radius};
    const Ray ray = {
        {centre.x - distance * away.x, centre.y - distance * away.y, centre.z - distance * away.z},
        {}};
    const scene::Vector3 aim = {distance * away.x + miss_by * aside.x,
                                distance * away.y + miss_by * aside.y,
                                distance * away.z + miss_by * aside.z};
    const double length = std::sqrt(aim.x * aim.x + aim.y * aim.y + aim.z * aim.z);
    if (length < 0.01) continue;
    return {{ray.origin, {aim.x / length, aim.y / length, aim.z / length}}, sphere};
  }
}

class EachPeer : public testing::TestWithParam<const fast::IntersectMethod*> {};

TEST_P(EachPeer, KeepsItsBoundsInsideItsContract) {
  constexpr int kCases = 4000;
  const fast::IntersectMethod& peer = *GetParam();
  const reference::Neighbourhood around{Root::kNearest, Tangent::kHit, 16 * peer.unit_roundoff};
  int hits = 0;
  int misses = 0;
  int parameters = 0;
  int points = 0;
  Random random(1);
  for (int k = 0; k < kCases; ++k) {
    const auto [ray, sphere] = random_pair(random, peer.contract);
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere);
    const auto answer = peer.intersect_one(ray, sphere, Root::kNearest, Tangent::kHit);
    if (answer.has_value() != (at.hit_class == HitClass::kHit)) {
      const auto s = answer ? std::optional(answer->parameter) : std::nullopt;
      ASSERT_EQ(right_nearby(exact, sphere, around, s).found, reference::Nearby::kWitness)
          << peer.name << " case " << k;
      continue;
    }
    (answer ? hits : misses) += 1;
    if (!answer) continue;
    if (condition_of_parameter(exact, sphere, at) <= properties::kModerateCondition) {
      ++parameters;
      EXPECT_LE(reference::ulp_error(answer->parameter, exact.parameter(sphere, at)), peer.max_ulp)
          << peer.name << " case " << k;
    }
    if (condition_of_point(exact, sphere, at) <= properties::kModerateCondition) {
      ++points;
      EXPECT_LE(reference::relative_error(answer->point, exact.point(sphere, at)),
                peer.max_point_ulp)
          << peer.name << " case " << k;
    }
  }
  EXPECT_GT(hits, kCases / 2);
  EXPECT_GT(misses, kCases / 10);
  EXPECT_GT(parameters, kCases / 2);
  EXPECT_GT(points, kCases / 2);
}

TEST_P(EachPeer, AnswersByTheConventionsThatItFixes) {
  const fast::Contract& contract = GetParam()->contract;
  const auto meets = [&](const Ray& ray, Root root, Tangent tangent) {
    return GetParam()->intersect_one(ray, kUnitSphere, root, tangent).has_value();
  };
  if (!contract.origin_outside) {
    const Ray inside = {{0, 0.5, 0}, {1, 0, 0}};
    EXPECT_TRUE(meets(inside, Root::kNearest, Tangent::kHit));
    EXPECT_EQ(meets(inside, Root::kSmaller, Tangent::kHit), contract.root == Root::kNearest);
  }
  const Ray tangent = {{-5, 1, 0}, {1, 0, 0}};
  EXPECT_EQ(meets(tangent, Root::kNearest, Tangent::kHit), contract.tangent != Tangent::kMiss);
  EXPECT_EQ(meets(tangent, Root::kNearest, Tangent::kMiss), contract.tangent == Tangent::kHit);
  EXPECT_FALSE(meets({{5, 0, 0}, {1, 0, 0}}, Root::kNearest, Tangent::kHit));
}

TEST_P(EachPeer, NeedsUnitDirectionsWhereItAsksForThem) {
  const Ray ray = {{-5, 0, 0}, {8, 0, 0}};
  const auto hit = GetParam()->intersect_one(ray, kUnitSphere, Root::kNearest, Tangent::kHit);
  const bool right = hit && std::abs(hit->parameter - 0.5) < 1e-5;
  EXPECT_EQ(right, !GetParam()->contract.unit_direction);
}

TEST_P(EachPeer, AnswersOneRayAsItDoesABatch) {
  Random random(2);
  int hits = 0;
  for (int k = 0; k < 20; ++k) {
    std::vector<Ray> rays;
    Sphere sphere;
    for (int ray = 0; ray < 20; ++ray) {
      const Pair pair = random_pair(random, GetParam()->contract);
      if (ray == 0) sphere = pair.sphere;
      const scene::Vector3 from = pair.ray.origin - pair.sphere.centre;
      rays.push_back(
          {{sphere.centre.x + from.x, sphere.centre.y + from.y, sphere.centre.z + from.z},
           pair.ray.direction});
    }
    hits += expect_batch_is_single_calls(*GetParam(), rays, sphere, Root::kNearest, Tangent::kHit);
  }
  EXPECT_GT(hits, 100);
}

TEST_P(EachPeer, RefusesByTheNameOfTheField) { expect_refusals(*GetParam()); }

TEST(Peers, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const auto* peer : peers()) EXPECT_TRUE(names.insert(peer->name).second) << peer->name;
  EXPECT_TRUE(names.contains("core"));
}

const fast::IntersectMethod& peer(std::string_view name) {
  for (const auto* method : peers()) {
    if (method->name == name) return *method;
  }
  throw std::invalid_argument("no such peer: " + std::string(name));
}

TEST(Core, RefusesLengthsBeyondItsDomain) {
  const fast::IntersectMethod& core = peer("core");
  const double large = 2 * core.domain.largest_length;
  const double small = core.domain.smallest_length / 2;
  const Ray good = {{-5, 0, 0}, {1, 0, 0}};
  const auto expect_named = [](const std::string& refusal, const std::string& field) {
    EXPECT_NE(refusal.find(field), std::string::npos) << field << ": '" << refusal << "'";
  };
  expect_named(refusal_of(core, {good}, {{0, 0, 0}, large}), "sphere.radius");
  expect_named(refusal_of(core, {good}, {{0, 0, 0}, small}), "sphere.radius");
  expect_named(refusal_of(core, {good}, {{large, 0, 0}, 1}), "sphere.centre");
  expect_named(refusal_of(core, {{{0, large, 0}, {1, 0, 0}}}, kUnitSphere), "ray.origin");
  expect_named(refusal_of(core, {{{0, 0, 0}, {0, 0, small}}}, kUnitSphere), "ray.direction");
  EXPECT_EQ(refusal_of(core, {good}, {{0, 0, 0}, 0}), "");
}

TEST(Core, IsRightToTheEndsOfItsDomain) {
  const fast::IntersectMethod& core = peer("core");
  Random random(3);
  int hits = 0;
  int misses = 0;
  for (int k = 0; k < 400; ++k) {
    auto [ray, sphere] = random_pair(random, {});
    const double scale = std::ldexp(1, static_cast<int>(random.integer(-190, 190)));
    const double stretch = std::ldexp(1, static_cast<int>(random.integer(-190, 190)));
    ray.origin = {scale * ray.origin.x, scale * ray.origin.y, scale * ray.origin.z};
    ray.direction = {stretch * ray.direction.x, stretch * ray.direction.y,
                     stretch * ray.direction.z};
    sphere = {{scale * sphere.centre.x, scale * sphere.centre.y, scale * sphere.centre.z},
              scale * sphere.radius};
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere);
    const auto answer = core.intersect_one(ray, sphere, Root::kNearest, Tangent::kHit);
    ASSERT_EQ(answer.has_value(), at.hit_class != HitClass::kMiss) << "case " << k;
    (answer ? hits : misses) += 1;
    if (!answer) continue;
    EXPECT_LE(reference::ulp_error(answer->parameter, exact.parameter(sphere, at)), core.max_ulp)
        << "case " << k;
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(misses, 20);
}

INSTANTIATE_TEST_SUITE_P(Peers, EachPeer, testing::ValuesIn(peers().begin(), peers().end()),
                         fast::test_name);

}  // namespace
}  // namespace raycheck::peers
