#include "properties/candidates/reference_methods.h"

#include "fast/ray_by_ray.h"
#include "reference/exact_ray.h"
#include "reference/interval_ray.h"

namespace raycheck::properties {
namespace {

using reference::Enclosure;
using reference::Engine;
using reference::ExactRay;
using reference::HitClass;
using reference::Intersection;
using reference::WhichRoot;

/// Hit classes are exact outside this range, too. Inside it, quotients of lengths are normal
/// doubles, so errors can be counted in ulp of s and u of |Q|.
constexpr fast::Domain kWideDomain = {.smallest_length = 0x1p-500, .largest_length = 0x1p500};

/// The precision of `arb-128`, in bits.
constexpr int kArbBits = 128;
/// s is correctly rounded, so it is off by at most half an ulp. Each coordinate of Q is correctly
/// rounded, too, so Q is off by at most u |Q|.
constexpr double kCorrectlyRoundedUlp = 0.5;
constexpr double kCorrectlyRoundedPointUlp = 1;
/// The rounding errors of 128-bit balls stay below this for the condition numbers that the bounds
/// cover.
constexpr double kLostByArb = 0x1p-30;

template <Engine engine>
struct Ladder {
  const scene::Sphere& sphere;

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::HitRule rule) const {
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere, rule.root, {engine});
    if (!reference::counts_as_hit(at.hit_class, rule.tangent)) return std::nullopt;
    return fast::Hit{exact.rounded_parameter(sphere, at), exact.rounded_point(sphere, at)};
  }
};

struct Intervals {
  const scene::Sphere& sphere;

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::HitRule rule) const {
    const auto found = reference::intersect_by_intervals(ray, sphere, rule.root);
    if (!found || !reference::counts_as_hit(found->intersection.hit_class, rule.tangent)) {
      return std::nullopt;
    }
    return fast::hit_at(ray, found->lower + (found->upper - found->lower) / 2);
  }
};

/// The sign of the midpoint: if the sign of the ball is certain, it is the same.
int sign_of_midpoint(const Enclosure& value) { return arf_sgn(arb_midref(value.ball())); }

/// The midpoint as a double. If the ball is narrow enough, this is its value, correctly rounded.
double rounded(const Enclosure& value) {
  const double low = value.lower_rounded();
  const double high = value.upper_rounded();
  return low == high ? low : low + (high - low) / 2;
}

struct Arb {
  const scene::Sphere& sphere;

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::HitRule rule) const {
    const reference::EnclosedRay enclosed = ExactRay(ray).enclose(kArbBits);
    const int meets = sign_of_midpoint(enclosed.half_chord_sq(sphere));
    Intersection at;
    at.hit_class = meets < 0 ? HitClass::kMiss : meets == 0 ? HitClass::kTangent : HitClass::kHit;
    if (!reference::counts_as_hit(at.hit_class, rule.tangent)) return std::nullopt;
    at.root = WhichRoot::kSmaller;
    Enclosure s = enclosed.parameter(sphere, at);
    if (sign_of_midpoint(s) < 0) {
      at.root = WhichRoot::kLarger;
      if (rule.root == scene::Root::kNearest) s = enclosed.parameter(sphere, at);
      if (sign_of_midpoint(s) < 0) return std::nullopt;
    }
    const reference::Enclosure3 Q = enclosed.point(sphere, at);
    return fast::Hit{rounded(s), {rounded(Q.x), rounded(Q.y), rounded(Q.z)}};
  }
};

}  // namespace

const fast::IntersectMethod kArb = {
    .name = "arb-128",
    .sentence = "a r^2 - |T x D|^2 and its roots in Arb's balls of 128 bits, by their midpoints",
    .intersect = fast::intersect_ray_by_ray<Arb>,
    .intersect_one = fast::intersect_one_ray<Arb>,
    .max_ulp = kCorrectlyRoundedUlp + kLostByArb,
    .max_point_ulp = kCorrectlyRoundedPointUlp + kLostByArb,
    .not_kept = "tangents and sizes 2^60 apart, which 128 bits do not separate",
    .domain = kWideDomain,
};

const fast::IntersectMethod kReferenceIntervals = {
    .name = "reference-intervals",
    .sentence = "only the reference's intervals of doubles; undecided pairs are misses",
    .intersect = fast::intersect_ray_by_ray<Intervals>,
    .intersect_one = fast::intersect_one_ray<Intervals>,
    .max_ulp = 96,
    .max_point_ulp = 192,
    .not_kept = "grazing rays and origins on the surface, which intervals do not decide",
};

const fast::IntersectMethod kReference = {
    .name = "reference",
    .sentence = "the reference: intervals, then balls, then the exact field; correctly rounded",
    .intersect = fast::intersect_ray_by_ray<Ladder<Engine::kFiltered>>,
    .intersect_one = fast::intersect_one_ray<Ladder<Engine::kFiltered>>,
    .max_ulp = kCorrectlyRoundedUlp,
    .max_point_ulp = kCorrectlyRoundedPointUlp,
    .domain = kWideDomain,
    .exact_class = true,
};

const fast::IntersectMethod kReferenceField = {
    .name = "reference-field",
    .sentence = "the reference with every hit class from the exact field; correctly rounded",
    .intersect = fast::intersect_ray_by_ray<Ladder<Engine::kFieldOnly>>,
    .intersect_one = fast::intersect_one_ray<Ladder<Engine::kFieldOnly>>,
    .max_ulp = kCorrectlyRoundedUlp,
    .max_point_ulp = kCorrectlyRoundedPointUlp,
    .domain = kWideDomain,
    .exact_class = true,
};

std::span<const fast::IntersectMethod* const> exact_methods() {
  static constexpr const fast::IntersectMethod* kMethods[] = {&kArb, &kReferenceIntervals,
                                                              &kReference, &kReferenceField};
  return kMethods;
}

}  // namespace raycheck::properties
