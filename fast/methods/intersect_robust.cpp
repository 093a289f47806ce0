#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_robust.cpp"
#include <hwy/foreach_target.h>

#include <cstring>
#include <type_traits>

#include "fast/internal/error_free.h"
#include "fast/internal/robust.h"
#include "fast/internal/robust_guess.h"
#include "fast/internal/robust_residual.h"
#include "scene/validate.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

// The first step of `robust`: robust_guess.h, then one Newton step. Its residual is computed in
// multiples of powers of 2.
//
// The first value s0. Let h = sqrt(disc), t = disc/(a r^2) <= 1 and x = f/r. "Near" means that disc
// is computed as b^2 - a c, "far" that it is computed with |m|^2. By the margins, t > 0.99 (2^-13 +
// 2^-31 x^2), and near, t > 0.99 (2^-13 + 2^-28 x^2). On a hit |m| <= |d| r, hence f|d| <= |b| +
// |d| r <= q/sqrt(t), and f|d| <= 1.16 q if x > 2. The error of disc is
//   |disc^ - disc| <= 19u f^2 |d|^2 + 10u a r^2 + u disc              near,
//                  <= 8.6u f|d| |d| r + 9u a r^2 + 19u^2 f^2 |d|^2    far.
// It moves h by (9.5x + 5)u q/t near, or (11x + 3)u q/sqrt(t) if x > 2, and by 8.8u q/t far (the
// last term is negligible, as f|d| < 2^15.6 h). b^ is off by 4u q/sqrt(t), and later steps by at
// most 9.5u q. Together s0 is off by E q/a, where E is (9.5x + 5 + 4 sqrt(t) + 9.5t)u/t near, or
// (11x + 17)u/sqrt(t) if x > 2, and 24u/t far.
//
// Newton's step leaves an error of (E q/a)^2 a/(2h). If s = q/a, which counts only if c < 0 and
// hence q <= 2h, this is at most E^2 s. If s = |c|/q, let y = a|c|/h^2 = |x^2 - 1|/t; as a share of
// s, the error is (E^2/2) (1 + sqrt(1 + y))^3/y if c > 0, else (E^2/2) 8/y. Its bounds are:
//   far, y > 2^10: 0.55 (24u)^2 x/t^2.5 <= 2^-57.9, as t^2.5 > 2^-39.8 x;
//   near, x > 32: 0.55 (11.6x)^2 u^2 x/t^1.5 <= 2^-57.7; otherwise below 2^-59 if y > 1;
//   y < 1: 4E^2/y <= 2^-57.3, as |x^2 - 1| >= 2^-26, and E <= 14.6u/t at the least t.
// The computed 1/(2h) is off by a share of (9.5x^2 + 5)u/t + 6u near and (4.3x + 11)u/t far. This
// times the error of s0 is 2^-57.1 of s near, if x > 32, 2^-65 far, and 2^-57.3 if y < 1.
//
// The residual |L + s0 d - C|^2 - r^2. Let S be a power of 2 from 2M to 4M. L' is L rounded by
// adding S, off by at most u(|L| + S). (s0 d)' is rounded in the same way, but perhaps twice, and
// off by at most u(2|s0 d| + S). Both are multiples of 2^-53 S. L' + (s0 d)' is exact, as it is
// less than 1.1M. So is w, its difference to C', as |w| <= 1.01 r. v, the sum of the parts rounded
// off, is at most V = u(16M + 3f) < 2^-17 r (as f < 2^15.6 r, and M < 2^27.7 r by the margin of f^2
// - r^2), and off by 2.7u V per coordinate. The squares of w are split in the same way by 4r^2, and
// their high parts add up exactly. v's errors cost 9.45u V r; the product (2w + v) v, the low parts
// and their sums cost kRobustLow u V r more. The sum of these, divided by 2 s h, is the error as a
// share of s. Its parts are 800u^2 M r/(2 s h) <= 2^-60.3, as s h >= |f - r| max(2^-6.6 r, 2^-15.6
// f) > 2^-37 M r by the margin of f^2 - r^2, and 150u^2 f r/(2 s h) <= 2^-63.6.
//
// Together s is off by less than 2^-56.1 of itself before it is rounded, and by 0.62 ulp
// afterwards. Q = L + s d is made from L' + (s0 d)', the rest and the correction of s, and rounded
// once.

/// Whether Newton's step leaves an error below 2^-57 of s in each of three cases (beside the
/// surface, near and far), for the worst x that the margins allow. Both sides are squared, to avoid
/// roots.
constexpr bool leaves_little() {
  using Required = Margins<double>;
  constexpr double kUnit = 0x1p-53, kMost = 0x1p-57;
  constexpr double kDisc = Required::kDiscriminantShare, kNear = Required::kNearShare;
  constexpr double kSurface = 4 * 14.6 * 14.6 * kUnit * kUnit;
  constexpr double kOfNear = 0.55 * 11.6 * 11.6 * kUnit * kUnit;
  constexpr double kOfFar = 0.55 * 24 * 24 * kUnit * kUnit;
  return kSurface < kMost * kDisc * Required::kSurfaceShare &&
         kOfNear * kOfNear < kMost * kMost * kNear * kNear * kNear &&
         kOfFar * kOfFar <
             kMost * kMost * 12.2 * Required::kFarShare * kDisc * kDisc * kDisc * kDisc;
}
static_assert(leaves_little());
// Checks the residual's 800u^2 and 150u^2, and that the rests of squares are below 0.32 V r.
static_assert(16 * (9.45 + kRobustLow) <= 800 && 3 * (9.45 + kRobustLow) <= 150 &&
              5.1 <= 0.32 * 16);

/// The largest power of 2 that is at most x (Rump, Ogita and Oishi, Accurate floating-point
/// summation, 2008). Domain: x > 0, 2^53 x in range.
template <class N>
HWY_INLINE N first_bit(const N& x) {
  const N much = N(0x1p52 + 1) * x;
  return much - N(1 - 0x1p-53) * much;
}

/// Each coordinate rounded to a multiple of 2^-53 scale.
template <class N>
HWY_INLINE Triple<N> coarse_triple(const Triple<N>& x, const N& scale) {
  return {coarse(x.x, scale), coarse(x.y, scale), coarse(x.z, scale)};
}

/// A Ball with the coarse parts and the rests of the centre and of r^2, for the residual.
template <class N>
struct Target : Ball<N> {
  HWY_INLINE explicit Target(const SphereOf<N>& sphere)
      : Ball<N>(sphere),
        scale(N(4) * first_bit(this->reach)),
        high(coarse_triple(sphere.centre, scale)),
        low(sphere.centre - high),
        base(N(4) * this->square),
        end(mul_add(sphere.radius, sphere.radius, base) - base),
        end_rest(product_rest(sphere.radius, sphere.radius, end)) {}

  N scale;              ///< S.
  Triple<N> high, low;  ///< The coarse part of the centre, and the rest.
  N base;
  N end, end_rest;  ///< The coarse part of r^2, and the rest.
};

/// The hit after a Newton step from s0.
template <class N>
HWY_INLINE ChosenOf<N> correct(const RayOf<N>& ray, const Target<N>& ball, const First<N>& root) {
  const auto& [origin, direction] = ray;
  const N scale = ball.scale;
  const N s0 = root.s0;
  const Triple<N> from = coarse_triple(origin, scale);
  const Triple<N> by = {mul_add(s0, direction.x, scale) - scale,
                        mul_add(s0, direction.y, scale) - scale,
                        mul_add(s0, direction.z, scale) - scale};
  const Triple<N> point = from + by;
  const Triple<N> rest =
      Triple<N>{product_rest(s0, direction.x, by.x), product_rest(s0, direction.y, by.y),
                product_rest(s0, direction.z, by.z)} -
      (from - origin);
  const Triple<N> w = point - ball.high;
  const Triple<N> v = rest - ball.low;
  const N x = mul_add(w.x, w.x, ball.base) - ball.base;
  const N y = mul_add(w.y, w.y, ball.base) - ball.base;
  const N z = mul_add(w.z, w.z, ball.base) - ball.base;
  const Triple<N> rests = {product_rest(w.x, w.x, x), product_rest(w.y, w.y, y),
                           product_rest(w.z, w.z, z)};
  const N low = low_of_residual(w, v, rests, ball.end_rest);
  const N correction = (((x + y) + (z - ball.end)) + low) * root.per_slope;
  const Triple<N> moved = {sub_mul(correction, direction.x, rest.x),
                           sub_mul(correction, direction.y, rest.y),
                           sub_mul(correction, direction.z, rest.z)};
  return {s0 == s0, s0 - correction, point + moved};
}

bool any_hit(const std::uint8_t* codes) {
  std::uint64_t all = 0;
  std::memcpy(&all, codes, kLaneCount);
  return all != 0;
}

constexpr std::size_t kBlock = 128;
static_assert(kBlock % kLaneCount == 0 && kLaneCount <= sizeof(std::uint64_t));

/// A BatchKernel for multiples of kLaneCount. It makes two passes over data that fits the L1 cache,
/// since the operations of one vector, in one pass, would be too many for the processor to overlap
/// with the next vector.
template <class BallAt, bool kRoots>
HWY_INLINE void answer_all(const BatchInput& asked, const HitArrays& to, const BallAt& ball_at) {
  const Lanes nothing(std::nan(""));
  for (std::size_t first = 0; first < asked.count; first += kBlock) {
    const std::size_t last = first + kBlock < asked.count ? first + kBlock : asked.count;
    for (std::size_t k = first; k < last; k += kLaneCount) {
      const Guess<Lanes> found = guess(load(asked.rays, k), ball_at(k), asked.rule.root);
      std::uint64_t codes = bytes(found.hit);
      if constexpr (kRoots) {  // The slope of |T - s d|^2 is positive at the larger root.
        const auto larger = found.hit & (found.root.per_slope > Lanes(0.0));
        if (any(larger)) [[unlikely]]
          codes |= kLargerRoot * bytes(larger);
      }
      if (!all(found.certain)) [[unlikely]]
        codes |= kOpen * bytes(!found.certain);
      store(codes, to.hit + k);
      // From a NaN, correct() makes only NaNs.
      store(kRoots ? select(found.hit, found.root.s0, nothing) : found.root.s0, to.parameter + k);
      store(found.root.per_slope, to.point[0] + k);
    }
    for (std::size_t k = first; k < last; k += kLaneCount) {
      if (!any_hit(to.hit + k)) {
        if constexpr (kRoots) store(Triple<Lanes>{nothing, nothing, nothing}, to.point, k);
        continue;
      }
      const ChosenOf<Lanes> chosen =
          correct(load(asked.rays, k), ball_at(k), {load(to.parameter + k), load(to.point[0] + k)});
      store(chosen.parameter, to.parameter + k);
      store(chosen.point, to.point, k);
    }
  }
}

[[gnu::flatten]] HWY_NOINLINE bool answer_whole(const BatchInput& input, const HitArrays& answers) {
  const BatchInput asked = input;
  const HitArrays to = answers;
  const Target<Lanes> ball(sphere_of<Lanes>(asked.sphere));
  const auto same = [&](std::size_t /*k*/) -> const Target<Lanes>& { return ball; };
  answer_all<decltype(same), false>(asked, to, same);
  return true;
}

bool robust_batch(const BatchInput& input, const HitArrays& answers) {
  return answer_batch(answer_whole, input, answers);
}

/// The same with roots, and NaNs for misses. Rays have one sphere, or each its own.
[[gnu::flatten]] HWY_NOINLINE bool decide_whole(const BatchInput& input, const HitArrays& answers) {
  const BatchInput asked = input;
  const HitArrays to = answers;
  if (asked.spheres != nullptr) {
    const SphereArrays spheres = *asked.spheres;
    const auto own = [&](std::size_t k) { return Target<Lanes>(load(spheres, k)); };
    answer_all<decltype(own), true>(asked, to, own);
  } else {
    const Target<Lanes> ball(sphere_of<Lanes>(asked.sphere));
    const auto same = [&](std::size_t /*k*/) -> const Target<Lanes>& { return ball; };
    answer_all<decltype(same), true>(asked, to, same);
  }
  return true;
}

bool decide_batch(const BatchInput& input, const HitArrays& answers) {
  return answer_batch(decide_whole, input, answers);
}

template <class N>
HWY_INLINE N number_at(const double* from) {
  if constexpr (std::is_same_v<N, double>) {
    return *from;
  } else {
    return load(from);
  }
}
template <class N>
HWY_INLINE N bound_or_infinity(const N& bound, const N& value) {
  return select((bound < N(HUGE_VAL)) | (!(value == value)), bound, N(HUGE_VAL));
}

template <class N>
HWY_INLINE void bounds_at(std::size_t k, const BatchInput& input, const HitArrays& of,
                          double* s_error, double* const (&point_error)[3]) {
  const N s = number_at<N>(of.parameter + k), least(kLeastDouble);
  if (s_error != nullptr) {
    store(bound_or_infinity(N(kDecidedS) * absolute(s) + least, s), s_error + k);
  }
  if (point_error[0] == nullptr) return;
  const scene::Sphere& one = input.sphere;
  const double given[] = {one.centre.x, one.centre.y, one.centre.z};
  N reach = input.spheres != nullptr ? number_at<N>(input.spheres->radius + k) : N(one.radius);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const N centre =
        input.spheres != nullptr ? number_at<N>(input.spheres->centre[axis] + k) : N(given[axis]);
    reach = reach + (absolute(centre) + absolute(number_at<N>(input.rays.origin[axis] + k)));
  }
  const N rest = N(kDecidedReach) * reach + least;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const N step = absolute(s * number_at<N>(input.rays.direction[axis] + k));
    const N point = number_at<N>(of.point[axis] + k);
    const N bound = N(kDecidedPoint) * absolute(point) + (N(kDecidedStep) * step + rest);
    store(bound_or_infinity(bound, point), point_error[axis] + k);
  }
}

[[gnu::flatten]] void bound_batch(const BatchInput& input, const HitArrays& of, double* s_error,
                                  double* const (&point_error)[3]) {
  std::size_t k = 0;
  for (; k + kLaneCount <= input.count; k += kLaneCount) {
    bounds_at<Lanes>(k, input, of, s_error, point_error);
  }
  for (; k < input.count; ++k) bounds_at<double>(k, input, of, s_error, point_error);
}

/// The first step's answer to one ray; empty if it is not certain.
[[gnu::flatten]] std::optional<Chosen> robust_one(const scene::Ray& ray,
                                                  const scene::Sphere& sphere,
                                                  scene::HitRule rule) {
  const auto asked = ray_of<double>(ray);
  const Target<double> ball(sphere_of<double>(sphere));
  const Guess<double> found = guess(asked, ball, rule.root);
  if (found.hit) return plain(correct(asked, ball, found.root));
  return found.certain ? std::optional<Chosen>({false, {}}) : std::nullopt;
}

}  // namespace
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
namespace {

HWY_EXPORT(robust_batch);
HWY_EXPORT(decide_batch);
HWY_EXPORT(bound_batch);
HWY_EXPORT(robust_one);

void intersect_by_robust(const Rays& rays, const scene::Sphere& sphere, scene::HitRule rule,
                         Hits& hits) {
  const auto& [input, answers] =
      intersect_by(HWY_DYNAMIC_DISPATCH(robust_batch), rays, sphere, rule, hits);
  settle(input, answers, false);
  const std::uint8_t* const codes = hits.hit.data();
  const bool is_empty = hits.size() == 0;  // then memchr() may not be called
  if (!is_empty && std::memchr(codes, kOpen, hits.size()) != nullptr) require_valid(rays, sphere);
}

std::optional<Hit> one_by_robust(const scene::Ray& ray, const scene::Sphere& sphere,
                                 scene::HitRule rule) {
  const std::optional<Chosen> first = HWY_DYNAMIC_DISPATCH(robust_one)(ray, sphere, rule);
  if (first) return first->if_hit();
  const auto proven = answer_by_pairs(ray, sphere, rule.root);
  return (proven ? *proven : answer_by_integers(ray, sphere, rule)).if_hit();
}

}  // namespace

void decide(const BatchInput& input, const HitArrays& answers) {
  BatchInput asked = input;
  asked.rule.tangent = scene::Tangent::kHit;
  if (!(asked.sphere.radius >= 0)) asked.sphere.radius = std::nan("");
  HWY_DYNAMIC_DISPATCH(decide_batch)(asked, answers);
  settle(asked, answers, true);
}

void bound_errors(const BatchInput& input, const HitArrays& answers, double* s_error,
                  double* const (&point_error)[3]) {
  HWY_DYNAMIC_DISPATCH(bound_batch)(input, answers, s_error, point_error);
}

/// On every valid input the class is exact and s is within max_ulp, even if s is subnormal. s
/// overflows to infinity as IEEE-754 says. kWideDomain limits only the promise for Q.
const IntersectMethod kRobust = {
    .name = "robust",
    .sentence =
        "a root with one proved correction; where no proof applies, pairs of doubles, then "
        "integers",
    .intersect = intersect_by_robust,
    .intersect_one = one_by_robust,
    .max_ulp = 1,
    .max_point_ulp = 1.5,
    .domain = kWideDomain,
    .exact_class = true,
};

}  // namespace raycheck::fast
#endif
