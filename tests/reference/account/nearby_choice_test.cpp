// Witnesses and refutations of wrong choices among spheres, against rational arithmetic.

#include "reference/account/nearby_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/reference/account/changed_choice.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Ray;
using scene::Root;
using scene::Sphere;
using scene::Tangent;
using What = FirstMet::What;

const Ray kFromMinusFive{{-5, 0, 0}, {1, 0, 0}};

Nearby found(const Ray& ray, const Spheres& spheres, const FirstMet& claim, double change = kChange,
             Root root = Root::kNearest, Tangent tangent = Tangent::kHit) {
  return right_nearby(ExactRay(ray), spheres, {root, tangent, change}, claim).found;
}

TEST(NearbyChoice, TellsToTheLastBitHowCloseTwoSpheresAre) {
  // The far one's front is 1 - k u of the near one's radius away from it.
  for (int k = 1; k <= 80; ++k) {
    const Spheres spheres = {{{0, 0, 0}, 1}, {{0, 0, 0}, 1 - k * kU}};
    if (k == 32) continue;  // 256 u^2 alone decides
    EXPECT_EQ(found(kFromMinusFive, spheres, {What::kSphere, 1}),
              k < 32 ? Nearby::kWitness : Nearby::kRefuted)
        << k;
  }
}

TEST(NearbyChoice, WithoutSpheresNothingIsMet) {
  EXPECT_EQ(found(kFromMinusFive, {}, {What::kNothing}), Nearby::kWitness);
  EXPECT_EQ(found(kFromMinusFive, {}, {What::kSomething}), Nearby::kRefuted);
  EXPECT_THROW(found(kFromMinusFive, {}, {What::kSphere, 0}), std::invalid_argument);
}

/// A sphere as large or small as it takes to pass close by a point of the ray.
Sphere through(Random& random, const scene::Point3& point) {
  Sphere sphere = random_sphere(random, Sizes::kOrdinary);
  const scene::Vector3 off = point - sphere.centre;
  sphere.radius = std::hypot(off.x, off.y, off.z);
  return sphere;
}

double slightly_changed(Random& random, double x) {
  switch (random.integer(0, 3)) {
    case 0:
      return x;
    case 1:
      return nudged(x, random.integer(-3, 3));
    case 2:
      return nudged(x, random.integer(-60, 60));
    default:
      return x * (1 + random.sign() * std::pow(10, -static_cast<double>(random.integer(3, 16))));
  }
}

/// Spheres that a ray meets nearly at once, nearly touches, or starts nearly on.
Spheres critical_spheres(Random& random, const Ray& ray) {
  const auto& [o, d] = ray;
  Spheres spheres;
  const double s = random.between(0, 3);
  const scene::Point3 met{o.x + s * d.x, o.y + s * d.y, o.z + s * d.z};
  const auto count = random.integer(2, 5);
  while (static_cast<std::int64_t>(spheres.size()) < count) {
    Sphere sphere;
    switch (random.integer(0, 5)) {
      case 0:
      case 1:
        sphere = through(random, met);
        break;
      case 2: {  // touched
        sphere = random_sphere(random, Sizes::kOrdinary);
        const double rest = sphere.radius * sphere.radius -
                            ExactRay(ray).enclose(128).half_chord_sq(sphere).upper();
        sphere.radius = std::sqrt(std::max(0.0, rest));
        break;
      }
      case 3:
        sphere = through(random, ray.origin);
        break;
      case 4:
        if (!spheres.empty()) {
          sphere = spheres.back();
          break;
        }
        [[fallthrough]];
      default:
        sphere = random_sphere(random, Sizes::kOrdinary);
    }
    if (random.one_in(2)) sphere.radius = slightly_changed(random, sphere.radius);
    if (random.one_in(4)) sphere.centre.x = slightly_changed(random, sphere.centre.x);
    if (scene::defects(sphere).empty()) spheres.push_back(sphere);
  }
  return spheres;
}

/// Every claim about a ray.
std::vector<FirstMet> claims(const Spheres& spheres) {
  std::vector<FirstMet> result = {{What::kNothing}, {What::kSomething}};
  for (std::size_t k = 0; k < spheres.size(); ++k) result.push_back({What::kSphere, k});
  return result;
}

struct Counts {
  int witnesses = 0, refutations = 0, undecided = 0;
};

std::string spelled_all(const Ray& ray, const Spheres& spheres, const FirstMet& claim) {
  std::string text = spelled(ray);
  for (const Sphere& sphere : spheres) text += spelled(sphere);
  return text + " claim " + std::to_string(static_cast<int>(claim.what)) + " " +
         std::to_string(claim.sphere);
}

/// Holds what is found of a wrong claim against fractions.
void expect_agreement(Random& random, const Ray& ray, const Spheres& spheres,
                      const Neighbourhood& around, const FirstMet& claim, Counts& counts) {
  const NearbyAnswer nearby = right_nearby(ExactRay(ray), spheres, around, claim);
  const auto is_right = [&](const InputChange& change) {
    return ChangedChoice(ray, spheres, change, around.root, around.tangent).is_right(claim);
  };
  const double most = around.relative_change;
  if (nearby.found == Nearby::kWitness) {
    ++counts.witnesses;
    ASSERT_LE(nearby.witness.size(), 6 + 4 * spheres.size());
    for (const double share : nearby.witness) ASSERT_LE(std::abs(share), most);
    ASSERT_TRUE(is_right(nearby.witness)) << spelled_all(ray, spheres, claim);
    return;
  }
  ++(nearby.found == Nearby::kRefuted ? counts.refutations : counts.undecided);
  for (int place = 0; place < 16; ++place) {
    InputChange change(6 + 4 * spheres.size());
    const bool at_corner = random.one_in(2);
    for (double& share : change) {
      share =
          most * (at_corner ? static_cast<double>(random.integer(-1, 1)) : random.between(-1, 1));
    }
    ASSERT_FALSE(is_right(change)) << spelled_all(ray, spheres, claim);
  }
}

Counts agreement_at(double change, int cases, std::uint64_t seed) {
  Random random(seed);
  Counts counts;
  for (int k = 0; k < cases; ++k) {
    const Ray ray = random_ray(random, random.one_in(4) ? Sizes::kSmallIntegers : Sizes::kOrdinary);
    const Spheres spheres = critical_spheres(random, ray);
    const Root root = random.one_in(3) ? Root::kSmaller : Root::kNearest;
    const Tangent tangent = random.one_in(3) ? Tangent::kMiss : Tangent::kHit;
    const Neighbourhood around{root, tangent, change};
    for (const FirstMet& claim : claims(spheres)) {
      if (ChangedChoice(ray, spheres, {}, root, tangent).is_right(claim)) continue;
      expect_agreement(random, ray, spheres, around, claim, counts);
    }
  }
  return counts;
}

TEST(NearbyChoice, OfNearTiesIsWitnessedOrRefutedAndFractionsAgree) {
  const Counts counts = agreement_at(kChange, 1500, 3);
  EXPECT_GE(counts.witnesses, 500);
  EXPECT_GE(counts.refutations, 500);
  EXPECT_EQ(counts.undecided, 0);
}

TEST(NearbyChoice, OfWideNeighbourhoodsFractionsAgreeToo) {
  for (const double change : {1e-12, 1e-6, 1e-2}) {
    const Counts counts = agreement_at(change, 400, 4);
    EXPECT_GE(counts.witnesses, 200);
    EXPECT_GE(counts.refutations, 200);
    // What a change by a hundredth does is far from linear.
    EXPECT_LE(counts.undecided, change < 1e-2 ? 0 : 10);
  }
}

}  // namespace
}  // namespace raycheck::reference
