// Witnesses and refutations of wrong answers, against rational arithmetic.

#include "reference/account/nearby_answer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
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
using Integer = boost::multiprecision::mpz_int;

Ray at_height(double y) { return {{-5, y, 0}, {1, 0, 0}}; }

Nearby found(const Ray& ray, const Sphere& sphere, const std::optional<double>& answer,
             double change = kChange, Root root = Root::kNearest, Tangent tangent = Tangent::kHit) {
  return right_nearby(ExactRay(ray), sphere, {root, tangent, change}, answer).found;
}

/// The ten inputs of a ray and a sphere, in the order of InputChange.
std::array<Fraction, 10> fractions(const Ray& ray, const Sphere& sphere) {
  const auto& [o, d] = ray;
  const auto& c = sphere.centre;
  return {Fraction(o.x), Fraction(o.y), Fraction(o.z), Fraction(d.x), Fraction(d.y),
          Fraction(d.z), Fraction(c.x), Fraction(c.y), Fraction(c.z), Fraction(sphere.radius)};
}

/// How the sphere is met at changed inputs.
Met changed(const Ray& ray, const Sphere& sphere, const InputChange& change, Root root) {
  EXPECT_EQ(change.size(), 10U);
  return ChangedChoice(ray, {sphere}, change, root, Tangent::kHit).first();
}

/// The root that is asked for, to 2^-300, of what is met.
Fraction asked_root(const Met& met) {
  const Fraction scale(Integer(1) << 600);
  const Fraction scaled = met.discriminant * scale;
  const Integer whole = numerator(scaled) / denominator(scaled);
  const Fraction root = Fraction(Integer(sqrt(whole))) / Fraction(Integer(1) << 300);
  return (met.b + met.root * root) / met.a;
}

/// Whether s is the root asked for at changed inputs, up to what is documented.
bool is_root(const Ray& ray, const Sphere& sphere, double s, double change, const Met& q) {
  if (q.root == 0) return false;
  const std::array<Fraction, 10> x = fractions(ray, sphere);
  const Fraction at(s);
  Fraction to_centre = 0;
  Fraction along = 0;
  Fraction reach = 2 * x[9] * x[9];
  for (std::size_t k = 0; k < 3; ++k) {
    const Fraction t = x[6 + k] - x[k];
    to_centre = std::max(to_centre, absolute(t));
    along = std::max(along, absolute(x[3 + k]));
    reach += 2 * absolute(t - at * x[3 + k]) *
             (absolute(x[k]) + absolute(x[6 + k]) + absolute(at * x[3 + k]));
  }
  const Fraction share(change);
  const Fraction root = asked_root(q);
  const Fraction off = absolute(at - root);
  const Fraction apart = off + 2 * absolute(q.b / q.a - root);
  return off <= (at + to_centre / along) * share || apart * apart * q.a <= reach * share;
}

/// Holds a witness against its claim, in fractions.
void expect_witness(const Ray& ray, const Sphere& sphere, const std::optional<double>& answer,
                    double change, const InputChange& witness, Root root) {
  const std::string what = spelled(ray) + spelled(sphere);
  for (const double share : witness) EXPECT_LE(std::abs(share), change) << what;
  const Met q = changed(ray, sphere, witness, root);
  EXPECT_TRUE(answer ? is_root(ray, sphere, *answer, change, q) : q.root == 0) << what;
}

/// (1 - k u)(1 + 16 u) > 1 - 16 u, by which a hit at height 1 - k u is nearly a miss, is k < 32;
/// and likewise (1 + k u)(1 - 16 u) <= 1 + 16 u above, where k is even.
TEST(NearbyAnswer, TellsToTheLastBitHowCloseAMissIs) {
  for (int k = 1; k <= 80; ++k) {
    if (k == 32) continue;  // 256 u^2 alone decides
    EXPECT_EQ(found(at_height(1 - k * kU), kUnit, std::nullopt),
              k < 32 ? Nearby::kWitness : Nearby::kRefuted)
        << k;
  }
  for (int k = 2; k <= 80; k += 2) {
    if (k == 32) continue;
    EXPECT_EQ(found(at_height(1 + k * kU), kUnit, 5.0),
              k < 32 ? Nearby::kWitness : Nearby::kRefuted)
        << k;
  }
}

TEST(NearbyAnswer, WhatIsNoParameterIsRefuted) {
  for (const double s : {-1.0, kInfinity, -kInfinity, std::nan("")}) {
    EXPECT_EQ(found(at_height(1), kUnit, s), Nearby::kRefuted);
  }
}

/// The answer that a decision turned round would give.
std::optional<double> wrong_answer(Random& random, const ExactRay& ray, const Sphere& sphere,
                                   Root root) {
  const Intersection at = ray.intersect(sphere, root);
  if (at.hit_class == HitClass::kMiss) {
    const double v = ray.enclose(128).axial_distance(sphere).upper();
    const double length = ray.enclose(128).length().upper();
    return random.one_in(4) ? 0 : std::max(0.0, v / length);
  }
  if (random.one_in(2)) return std::nullopt;
  const Intersection other{
      at.hit_class, at.root == WhichRoot::kSmaller ? WhichRoot::kLarger : WhichRoot::kSmaller};
  return std::max(0.0, ray.rounded_parameter(sphere, other));
}

/// A sphere that the ray almost touches, or almost starts on.
Sphere critical_sphere(Random& random, const Ray& ray) {
  Sphere sphere = random_sphere(random, Sizes::kOrdinary);
  const ExactRay exact(ray);
  const auto enclosed = exact.enclose(128);
  const double impact_sq = sphere.radius * sphere.radius - enclosed.half_chord_sq(sphere).upper();
  const double v = enclosed.axial_distance(sphere).upper();
  const double distance = random.one_in(2) ? std::sqrt(std::max(0.0, impact_sq))
                                           : std::sqrt(std::max(0.0, impact_sq + v * v));
  sphere.radius = nudged(distance, random.integer(-40, 40));
  return sphere;
}

/// A sphere so far that a change moves it by about its radius, nearly ahead of a ray.
Sphere far_sphere(Random& random, const Ray& ray, double change) {
  Sphere sphere;
  sphere.radius = random.between(0.1, 10);
  const double distance = sphere.radius / change * random.between(0.2, 5);
  const auto& [o, d] = ray;
  const double s = distance / std::hypot(d.x, d.y, d.z);
  const auto aside = [&] { return random.between(-1, 1) * sphere.radius; };
  sphere.centre.x = o.x + s * d.x + aside();
  sphere.centre.y = o.y + s * d.y + aside();
  sphere.centre.z = o.z + s * d.z + aside();
  return sphere;
}

struct AnswerCounts {
  int witnesses = 0, refutations = 0, undecided = 0;
};

/// Of wrong answers about rays and spheres: witnesses are right, and no corner of the neighbourhood
/// is where there is none.
template <class Make>
AnswerCounts fractions_agree(std::uint64_t seed, int cases, Make make) {
  Random random(seed);
  AnswerCounts counts;
  for (int k = 0; k < cases; ++k) {
    const auto [ray, sphere, most] = make(random);
    if (!scene::defects(sphere).empty()) continue;
    const ExactRay exact(ray);
    const Root root = random.one_in(2) ? Root::kSmaller : Root::kNearest;
    const auto answer = wrong_answer(random, exact, sphere, root);
    const NearbyAnswer nearby =
        right_nearby(exact, sphere, {.root = root, .relative_change = most}, answer);
    if (nearby.found == Nearby::kWitness) {
      ++counts.witnesses;
      expect_witness(ray, sphere, answer, most, nearby.witness, root);
      continue;
    }
    ++(nearby.found == Nearby::kRefuted ? counts.refutations : counts.undecided);
    for (int corner = 0; corner < 24; ++corner) {
      InputChange change;
      for (int input = 0; input < 10; ++input) {
        change.push_back(most * static_cast<double>(random.integer(-1, 1)));
      }
      const Met q = changed(ray, sphere, change, root);
      const bool is_right = answer ? is_root(ray, sphere, *answer, most, q) : q.root == 0;
      EXPECT_FALSE(is_right) << spelled(ray) << spelled(sphere);
    }
  }
  return counts;
}

struct Problem {
  Ray ray;
  Sphere sphere;
  double change;
};

TEST(NearbyAnswer, OfCriticalRaysIsWitnessedOrRefutedAndFractionsAgree) {
  const AnswerCounts counts = fractions_agree(12, 4000, [](Random& random) {
    const Ray ray = random_ray(random, random.one_in(4) ? Sizes::kSmallIntegers : Sizes::kOrdinary);
    return Problem{ray, critical_sphere(random, ray), kChange};
  });
  EXPECT_GE(counts.witnesses, 500);
  EXPECT_GE(counts.refutations, 500);
  EXPECT_EQ(counts.undecided, 0);
}

TEST(NearbyAnswer, OfNeighbourhoodsAsWideAsASphereFractionsAgree) {
  const AnswerCounts counts = fractions_agree(8, 1500, [](Random& random) {
    const double change = random.one_in(2) ? kChange : 0x1p-20;
    const Ray ray = random_ray(random, Sizes::kOrdinary);
    return Problem{ray, far_sphere(random, ray, change), change};
  });
  EXPECT_GE(counts.witnesses, 300);
  EXPECT_GE(counts.refutations, 50);
  // Other roots about as far from right as the neighbourhood is wide.
  EXPECT_LE(counts.undecided, 25);
}

}  // namespace
}  // namespace raycheck::reference
