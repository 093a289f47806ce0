#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_robust.cpp"
#include <hwy/foreach_target.h>

#include <cstring>

#include "fast/internal/error_free.h"
#include "fast/internal/robust.h"
#include "fast/internal/robust_guess.h"
#include "scene/validate.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

// The first step: robust_guess.h, then one Newton step from a residual in pairs.
//
// The first root s0, of relative error e. Let t = disc/(a r^2) <= 1 and x = f/r, so that t > 0.99
// (2^-13 + 2^-31 x^2); then t^2.5 > 2^-39.8 x and t > 2^-21.1 x. On a hit |m| <= |d| r, hence f|d|
// <= |b| + |d| r <= 2q/sqrt(t), and
//   |disc^ - disc| <= 8.6u f|d| |d| r + 9u a r^2 + 19u^2 f^2 |d|^2
// moves q by at most 13.2u/t of itself (next to nothing from the last term, as f|d| < 2^15.6
// sqrt(disc)), b^ by 8u/sqrt(t): e <= 24u/t + 6u (f^2 + r^2)/|c|, the latter only through c.
//
// Newton's step leaves e^2 g, g = a s/(2 sqrt(disc)), of s. With c > 0, g <= f|d|/(2 sqrt(disc)) =
// x/(2 sqrt(t)) and g <= a c/(2 disc); with c < 0, a |c| = disc - b^2 and q <= 2 sqrt(disc) make g
// <= 1 and, through c, g <= a |c|/(2 disc).
//   (24u/t)^2 2 g <= (24u)^2 x/t^2.5 <= 2^-57, or (24u/t)^2 2 <= 2^-69
//   (6u (f^2 + r^2)/c)^2 2 g <= 2^-80 where f^2 >= 2r^2, since then f^2 + r^2 <= 3c;
//   otherwise <= 36u^2 ((f^2 + r^2)/|c|) 3/t <= 2^-58.5.
// sqrt(disc^) stands for sqrt(disc): off by at most 2^-29 of itself (2^-36 where f^2 < 2r^2), which
// times e is below 2^-59.
//
// The residual |C - L - s0 d|^2 - r^2 is taken from w = C - fl(L + s0 d), rounded, and the sum v of
// the roundings on the way there, each exact. s0 is so near that |w|^2 <= r^2 (1 + 2^-15), the
// domain of coarse_square; the high parts add up exactly, the low parts are off by 56u^2 r^2. Then
// |v| <= u(M + f + 2.1r) is off by at most u^2(2M + 3.1(f + r)), the product 2 w.v and the sums by
// at most 8u r |v| + 18u^2 r^2 more, and |v|^2 is left out: 120u^2 (M + f)^2 in all. Half of that
// over s sqrt(disc) is the error as a share of s:
//   120u^2 f^2/(s sqrt(disc)) <= 2^-64, as 200u^2/t at q/a and by q <= 2^8 sqrt(disc) where
//   f^2 < 2r^2, q <= 2^15.6 sqrt(disc) otherwise, at |c|/q;
//   120u^2 M^2/(s sqrt(disc)) <= 2^-58, as s sqrt(disc) >= |f - r| max(2^-6.6 r, 2^-15.6 f)
//   > 2^-40 M^2 by what is required of f^2 - r^2.
//
// All in all s is off by less than 2^-56 of itself before it is rounded: 0.63 ulp. Q = L + s d is
// made from fl(L + s0 d), its rounding error and the correction of s, and rounded once.
/// A coordinate of L + s0 d, and of C less that, as unevaluated sums.
template <class N>
struct Reached {
  N point, point_rest;
  N away, away_rest;
};

template <class N>
HWY_INLINE Reached<N> reached(N origin, N s0, N direction, N centre) {
  const Rounded<N> product = two_product(s0, direction);
  const Rounded<N> point = two_sum(origin, product.x);
  const N rest = point.error + product.error;
  const Rounded<N> away = two_difference(centre, point.x);
  return {point.x, rest, away.x, away.error - rest};
}

/// With the square of the radius as the residual takes it.
template <class N>
struct Target : Ball<N> {
  HWY_INLINE explicit Target(const SphereOf<N>& sphere)
      : Ball<N>(sphere), scale(N(2) * this->square), coarse(coarse_square(sphere.radius, scale)) {}

  N scale;
  Rounded<N> coarse;  ///< The square, in units of ulp(scale).
};

/// Newton's step from s0, and the point there.
template <class N>
ChosenOf<N> correct(const RayOf<N>& ray, const Target<N>& ball, const Guess<N>& found) {
  const auto& [origin, direction] = ray;
  const Reached<N> x = reached(origin.x, found.s0, direction.x, ball.centre.x);
  const Reached<N> y = reached(origin.y, found.s0, direction.y, ball.centre.y);
  const Reached<N> z = reached(origin.z, found.s0, direction.z, ball.centre.z);
  const Rounded<N> xx = coarse_square(x.away, ball.scale);
  const Rounded<N> yy = coarse_square(y.away, ball.scale);
  const Rounded<N> zz = coarse_square(z.away, ball.scale);
  const N residual = (((xx.x + yy.x) + zz.x) - ball.coarse.x) +
                     (((xx.error + yy.error) + (zz.error - ball.coarse.error)) +
                      N(2) * (x.away * x.away_rest + y.away * y.away_rest + z.away * z.away_rest));
  const N correction = residual / found.slope;
  return {found.hit,
          found.s0 - correction,
          {x.point + (x.point_rest - correction * direction.x),
           y.point + (y.point_rest - correction * direction.y),
           z.point + (z.point_rest - correction * direction.z)}};
}

bool any_hit(const std::uint8_t* codes) {
  std::uint64_t all = 0;
  std::memcpy(&all, codes, kLaneCount);
  return all != 0;
}

constexpr std::size_t kBlock = 128;
static_assert(kBlock % kLaneCount == 0 && kLaneCount <= sizeof(std::uint64_t));

/// A BatchKernel for multiples of kLaneCount. Two passes over data that fits the L1 cache: one
/// vector's chain of operations is too long for the next to start before it ends.
[[gnu::flatten]] HWY_NOINLINE bool answer_whole(const BatchInput& input, const HitArrays& answers) {
  const BatchInput asked = input;
  const HitArrays to = answers;
  const Target<Lanes> ball(sphere_of<Lanes>(asked.sphere));
  for (std::size_t first = 0; first < asked.count; first += kBlock) {
    const std::size_t last = first + kBlock < asked.count ? first + kBlock : asked.count;
    for (std::size_t k = first; k < last; k += kLaneCount) {
      const Guess<Lanes> found = guess(load(asked.rays, k), ball, asked.rule.root);
      std::uint64_t codes = bytes(found.hit);
      if (!all(found.certain)) [[unlikely]]
        codes |= kOpen * bytes(!found.certain);
      store(codes, to.hit + k);
      store(found.s0, to.parameter + k);
      store(found.slope, to.point[0] + k);
    }
    for (std::size_t k = first; k < last; k += kLaneCount) {
      if (!any_hit(to.hit + k)) continue;
      const Lanes slope = load(to.point[0] + k);
      const ChosenOf<Lanes> chosen =
          correct(load(asked.rays, k), ball,
                  {slope == slope, slope == slope, load(to.parameter + k), slope});
      store(chosen.parameter, to.parameter + k);
      store(chosen.point, to.point, k);
    }
  }
  return true;
}

bool batch(const BatchInput& input, const HitArrays& answers) {
  return answer_batch(answer_whole, input, answers);
}

/// The first step's answer to one ray; empty where it is not certain.
[[gnu::flatten]] std::optional<Chosen> one(const scene::Ray& ray, const scene::Sphere& sphere,
                                           scene::HitRule rule) {
  const auto asked = ray_of<double>(ray);
  const Target<double> ball(sphere_of<double>(sphere));
  const Guess<double> found = guess(asked, ball, rule.root);
  if (found.hit) return plain(correct(asked, ball, found));
  return found.certain ? std::optional<Chosen>({false, {}}) : std::nullopt;
}

}  // namespace
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
namespace {

HWY_EXPORT(batch);
HWY_EXPORT(one);

Chosen answer_carefully(const scene::Ray& ray, const scene::Sphere& sphere, scene::HitRule rule) {
  if (const auto proven = answer_by_pairs(ray, sphere, rule.root)) return *proven;
  return answer_by_integers(ray, sphere, rule);
}

void intersect(const Rays& rays, const scene::Sphere& sphere, scene::HitRule rule, Hits& hits) {
  intersect_by(HWY_DYNAMIC_DISPATCH(batch), rays, sphere, rule, hits);
  std::uint8_t* const first = hits.hit.data();
  std::uint8_t* const last = first + hits.size();
  for (std::uint8_t* open = first; open != last; ++open) {
    // Faster than std::find, which compares byte by byte.
    open =
        static_cast<std::uint8_t*>(std::memchr(open, kOpen, static_cast<std::size_t>(last - open)));
    if (open == nullptr) return;
    const auto k = static_cast<std::size_t>(open - first);
    const scene::Ray ray = rays.at(k);
    if (!scene::defects(ray).empty()) require_valid(rays, sphere);
    const Chosen chosen = answer_carefully(ray, sphere, rule);
    hits.set(k, chosen.hit, chosen.at);
  }
}

std::optional<Hit> intersect_one(const scene::Ray& ray, const scene::Sphere& sphere,
                                 scene::HitRule rule) {
  const std::optional<Chosen> first = HWY_DYNAMIC_DISPATCH(one)(ray, sphere, rule);
  return (first ? *first : answer_carefully(ray, sphere, rule)).if_hit();
}

}  // namespace

/// The class is exact and s within max_ulp on every valid input, also where s is subnormal; it
/// overflows to infinity as IEEE-754. kWideDomain is where Q's relative error means something.
const IntersectMethod kRobust = {
    .name = "robust",
    .sentence = "cross corrected once in pairs of doubles where proven; else pairs, integers",
    .intersect = intersect,
    .intersect_one = intersect_one,
    .max_ulp = 1,
    .max_point_ulp = 1.5,
    .domain = kWideDomain,
    .exact_class = true,
};

}  // namespace raycheck::fast
#endif
