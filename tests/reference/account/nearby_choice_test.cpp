// Checks witnesses and refutations of wrong choices among spheres: for given rays by rational
// arithmetic, for cameras by the changed cameras. tools/verify_certificates.py checks those of
// single answers, and all witnesses again.

#include "reference/account/nearby_choice.h"

#include <boost/multiprecision/gmp.hpp>

#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;
using What = FirstMet::What;
using Fraction = boost::multiprecision::mpq_rational;
using Spheres = std::vector<Sphere>;

constexpr double kU = 0x1p-53;
constexpr double kChange = 16 * kU;

int sign(const Fraction& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

/// The sign of p + q sqrt(x), x >= 0.
int sign_of_sum(const Fraction& p, const Fraction& q, const Fraction& x) {
  const int of_root = x == 0 ? 0 : sign(q);
  if (of_root == 0 || sign(p) == of_root) return of_root == 0 ? sign(p) : of_root;
  return sign(p) == 0 ? of_root : sign(p) * sign(p * p - q * q * x);
}

/// The sign of p + q sqrt(x) + r sqrt(y).
int sign_of_sum(const Fraction& p, const Fraction& q, const Fraction& x, const Fraction& r,
                const Fraction& y) {
  const int first = sign_of_sum(p, q, x);
  const int second = y == 0 ? 0 : sign(r);
  if (second == 0 || first == second) return second == 0 ? first : second;
  return first == 0 ? second : first * sign_of_sum(p * p + q * q * x - r * r * y, 2 * p * q, x);
}

/// A sphere's equation along a ray at changed inputs: a mu^2 - 2 b mu + c.
struct Met {
  Fraction b = 0, c = 0, discriminant = 0;
  int root = 0;  ///< The root that the conventions ask for: -1 or 1; 0: a miss.
};

/// A ray and spheres at changed inputs, and whether a claim is right there.
class ChangedChoice {
 public:
  ChangedChoice(const Ray& ray, const Spheres& spheres, const InputChange& change, Root root,
                Tangent tangent) {
    std::size_t next = 0;
    const auto input = [&](double x) {
      const std::size_t k = next++;
      return k < change.size() ? Fraction(x) * (1 + Fraction(change[k])) : Fraction(x);
    };
    const Fraction o[3] = {input(ray.origin.x), input(ray.origin.y), input(ray.origin.z)};
    const Fraction d[3] = {input(ray.direction.x), input(ray.direction.y), input(ray.direction.z)};
    const Fraction a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    for (const Sphere& sphere : spheres) {
      const double centre[3] = {sphere.centre.x, sphere.centre.y, sphere.centre.z};
      Met met;
      for (int axis = 0; axis < 3; ++axis) {
        const Fraction t = input(centre[axis]) - o[axis];
        met.b += t * d[axis];
        met.c += t * t;
      }
      const Fraction radius = input(sphere.radius);
      met.c -= radius * radius;
      met.discriminant = met.b * met.b - a * met.c;
      const bool is_met =
          met.discriminant > 0 || (met.discriminant == 0 && tangent == Tangent::kHit);
      if (is_met && met.c >= 0 && met.b >= 0) {
        met.root = -1;
      } else if (is_met && root == Root::kNearest && met.c <= 0) {
        met.root = 1;
      }
      met_.push_back(met);
    }
  }

  bool is_right(const FirstMet& claim) const {
    bool is_any = false;
    for (const Met& met : met_) is_any = is_any || met.root != 0;
    if (claim.what == What::kNothing) return !is_any;
    if (claim.what == What::kSomething) return is_any;
    const Met& first = met_[claim.sphere];
    if (first.root == 0) return false;
    for (const Met& met : met_) {
      if (met.root != 0 && sign_of_sum(met.b - first.b, met.root, met.discriminant, -first.root,
                                       first.discriminant) < 0) {
        return false;
      }
    }
    return true;
  }

 private:
  std::vector<Met> met_;
};

Nearby found(const Spheres& spheres, const FirstMet& claim) {
  const ExactRay ray(Ray{{-5, 0, 0}, {1, 0, 0}});
  return right_nearby(ray, spheres, {.relative_change = kChange}, claim).found;
}

TEST(NearbyChoice, DecidesCloseSpheresToTheLastBit) {
  // The front of the far sphere is k u behind that of the near sphere.
  for (int k = 1; k <= 80; ++k) {
    const Spheres spheres = {{{0, 0, 0}, 1}, {{0, 0, 0}, 1 - k * kU}};
    if (k == 32) continue;  // only 256 u^2 decides
    EXPECT_EQ(found(spheres, {What::kSphere, 1}), k < 32 ? Nearby::kWitness : Nearby::kRefuted)
        << k;
  }
}

TEST(NearbyChoice, WithoutSpheresNothingIsMet) {
  EXPECT_EQ(found({}, {What::kNothing}), Nearby::kWitness);
  EXPECT_EQ(found({}, {What::kSomething}), Nearby::kRefuted);
  EXPECT_THROW(found({}, {What::kSphere, 0}), std::invalid_argument);
}

/// A sphere whose surface passes close to a point of the ray.
Sphere through(Random& random, const scene::Point3& point) {
  Sphere sphere = random_sphere(random, Sizes::kOrdinary);
  const scene::Vector3 off = point - sphere.centre;
  sphere.radius = std::hypot(off.x, off.y, off.z);
  return sphere;
}

/// A sphere that the ray touches.
Sphere touched(Random& random, const ExactRay& ray) {
  Sphere sphere = random_sphere(random, Sizes::kOrdinary);
  const double d_sq = ray.enclose(128).half_chord_sq(sphere).upper();
  sphere.radius = std::sqrt(std::max(0.0, sphere.radius * sphere.radius - d_sq));
  return sphere;
}

double slightly_changed(Random& random, double x) {
  const auto kind = random.integer(0, 3);
  if (kind == 0) return x;
  if (kind == 1) return nudged(x, random.integer(-3, 3));
  if (kind == 2) return nudged(x, random.integer(-60, 60));
  return x * (1 + random.sign() * std::pow(10, -static_cast<double>(random.integer(3, 16))));
}

/// Spheres that a ray meets nearly at the same s, nearly touches, or nearly starts on.
Spheres critical_spheres(Random& random, const Ray& ray) {
  const auto& [o, d] = ray;
  Spheres spheres;
  const double s = random.between(0, 3);
  const scene::Point3 met{o.x + s * d.x, o.y + s * d.y, o.z + s * d.z};
  const auto count = random.integer(2, 5);
  while (static_cast<std::int64_t>(spheres.size()) < count) {
    const auto kind = random.integer(0, 5);
    Sphere sphere = kind <= 1                       ? through(random, met)
                    : kind == 2                     ? touched(random, ExactRay(ray))
                    : kind == 3                     ? through(random, ray.origin)
                    : kind == 4 && !spheres.empty() ? spheres.back()
                                                    : random_sphere(random, Sizes::kOrdinary);
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
  int witnesses = 0, not_right = 0, refutations = 0, undecided = 0;
};

/// Checks the result for a wrong claim about `inputs` numbers. The claim must be right at the
/// witness; without a witness, it must be wrong at random places within `most`.
template <class IsRight>
void expect_holds(Random& random, const NearbyAnswer& nearby, std::size_t inputs, double most,
                  int places, Counts& counts, const IsRight& is_right) {
  if (nearby.found == Nearby::kWitness) {
    ++counts.witnesses;
    ASSERT_LE(nearby.witness.size(), inputs);
    for (const double share : nearby.witness) ASSERT_LE(std::abs(share), most);
    counts.not_right += is_right(nearby.witness) ? 0 : 1;
    return;
  }
  ++(nearby.found == Nearby::kRefuted ? counts.refutations : counts.undecided);
  for (int place = 0; place < places; ++place) {
    InputChange change(inputs);
    const bool at_corner = random.one_in(2);
    for (double& share : change) {
      share = 0.999 * most * (at_corner ? random.sign() : random.between(-1, 1));
    }
    ASSERT_FALSE(is_right(change));
  }
}

Counts of_given_rays(double change, int cases, std::uint64_t seed) {
  Random random(seed);
  Counts counts;
  for (int k = 0; k < cases; ++k) {
    const Ray ray = random_ray(random, random.one_in(4) ? Sizes::kSmallIntegers : Sizes::kOrdinary);
    const Spheres spheres = critical_spheres(random, ray);
    const Root root = random.one_in(3) ? Root::kSmaller : Root::kNearest;
    const Tangent tangent = random.one_in(3) ? Tangent::kMiss : Tangent::kHit;
    for (const FirstMet& claim : claims(spheres)) {
      const auto is_right = [&](const InputChange& changed) {
        return ChangedChoice(ray, spheres, changed, root, tangent).is_right(claim);
      };
      if (is_right({})) continue;
      SCOPED_TRACE(spelled(ray) + spelled(spheres[0]) + spelled(spheres[1]));
      expect_holds(random, right_nearby(ExactRay(ray), spheres, {root, tangent, change}, claim),
                   6 + 4 * spheres.size(), change, 16, counts, is_right);
    }
  }
  return counts;
}

TEST(NearbyChoice, OfNearTiesAgreesWithFractions) {
  for (const double change : {kChange, 1e-12, 1e-6, 1e-2}) {
    const Counts counts = of_given_rays(change, change == kChange ? 600 : 160, 3);
    EXPECT_GE(counts.witnesses, 80);
    EXPECT_GE(counts.refutations, 80);
    EXPECT_EQ(counts.not_right, 0);
    // The effect of a change by a hundredth is far from linear.
    EXPECT_LE(counts.undecided, change < 1e-2 ? 0 : 4);
  }
}

/// A relative change far larger than rounding errors, so that changed inputs may be rounded.
constexpr double kWide = 0x1p-26;

/// Spheres whose surfaces or silhouettes all pass close to one point of the ray.
Spheres spheres_near_a_point(Random& random, const ExactRay& ray) {
  const scene::Point3 from = ray.rounded_origin();
  const scene::UnitVector3 along = ray.rounded_direction();
  const double s = random.between(0, 5);
  const scene::Point3 met{from.x + s * along.x, from.y + s * along.y, from.z + s * along.z};
  Spheres spheres;
  while (spheres.size() < 3) {
    Sphere sphere = random.one_in(3) ? touched(random, ray) : through(random, met);
    sphere.radius *= 1 + random.between(-6, 6) * kWide;
    if (scene::defects(sphere).empty()) spheres.push_back(sphere);
  }
  return spheres;
}

bool is_right_of(const FirstMet& claim, const std::optional<NearestSphere>& nearest) {
  if (claim.what == What::kNothing) return !nearest;
  return nearest && (claim.what == What::kSomething || nearest->index == claim.sphere);
}

TEST(NearbyChoice, OfCamerasHoldsForTheChangedCameras) {
  Random random(6);
  Counts counts;
  for (int k = 0; k < 240; ++k) {
    const scene::Camera camera = random_camera(random, Sizes::kOrdinary);
    const scene::Conventions conventions = random_conventions(random);
    const scene::Pixel pixel = random_pixel(random, camera);
    const ExactRay ray(ExactCamera(camera, conventions), pixel);
    const Spheres spheres = spheres_near_a_point(random, ray);
    for (const FirstMet& claim : claims(spheres)) {
      if (is_right_of(claim, ray.nearest(spheres, {}))) continue;
      SCOPED_TRACE(spelled(camera));
      expect_holds(random, right_nearby(ray, spheres, {.relative_change = kWide}, claim),
                   14 + 4 * spheres.size(), kWide, 6, counts, [&](const InputChange& change) {
                     scene::Camera moved = camera;
                     Spheres seen = spheres;
                     const auto inputs = inputs_of(moved, seen);
                     for (std::size_t j = 0; j < change.size(); ++j) *inputs[j] *= 1 + change[j];
                     const ExactRay other(ExactCamera(moved, conventions), pixel);
                     return is_right_of(claim, other.nearest(seen, {}));
                   });
    }
  }
  EXPECT_GE(counts.witnesses, 80);
  EXPECT_GE(counts.refutations, 80);
  EXPECT_EQ(counts.undecided, 0);
  EXPECT_LE(counts.not_right, counts.witnesses / 100);  // due to rounding
}

}  // namespace
}  // namespace raycheck::reference
