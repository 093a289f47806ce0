#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/intersect_robust.cpp"
#include <hwy/foreach_target.h>

#include "fast/error_free.h"
#include "fast/intersect_batch.h"
#include "fast/robust.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

// The first step: coefficients in doubles, then one of Newton's steps from a residual in pairs.
//
// Where f^2 + r^2 and a lie between these, no product overflows, and what underflows is too small
// to count beside the margins.
constexpr double kLeastSquare = 0x1p-400;
constexpr double kLargestSquare = 0x1p400;
// The step answers where |disc^| > kDiscriminantShare a r^2 + kFarShare a f^2 and
// |c^| > kSurfaceShare (f^2 + r^2).
//
// Signs. |m^ - m| <= 4.3u f|d|, and |disc^ - disc| <= 12u a (f^2 + r^2) + u |disc^|, less than a
// hundredth of what is asked; |c^ - c| <= 6u (f^2 + r^2). A miss by c and b needs no more of b:
// with c > 0 and disc > 0, b^2 > disc > kFarShare f^2 |d|^2 (0.99), while |b^ - b| <= 4u f|d|. With
// disc < 0 the ray misses whatever b is.
//
// The first root s0, of relative error e. Let t = disc/(a r^2) <= 1; on a hit |m| <= |d| r, hence
// f|d| <= |b| + |d| r <= 2q/sqrt(t), and
//   |disc^ - disc| <= 8.6u f|d| |d| r + 9u a r^2 + 19u^2 f^2 |d|^2
// moves q by at most 13.2u/t of itself (next to nothing from the last term, as f|d| < 2^20.1
// sqrt(disc)), b^ by 8u/sqrt(t): e <= 24u/t + 6u (f^2 + r^2)/|c|, the latter only through c.
//
// Newton's step leaves e^2 g, g = a s/(2 sqrt(disc)), of s. With c > 0, g <= f|d|/(2 sqrt(disc))
// <= 2^19 and g <= a c/(2 disc); with c < 0, g <= 1/sqrt(t) <= 2^5 and, through c, the same.
//   (24u/t)^2 2 g <= 2^-56.7                                   with 1/t <= 2^10
//   (6u (f^2 + r^2)/c)^2 2 g <= 2^-77 where f^2 >= 2r^2, since then f^2 + r^2 <= 3c;
//   otherwise <= 36u^2 ((f^2 + r^2)/|c|) 3/t <= 2^-59.
// sqrt(disc^) stands for the derivative's half, a s0 - b: off by at most 2^-25 of itself (2^-39
// where f^2 < 2r^2), which times e is below 2^-59.
//
// The residual p = |T - s0 d|^2 - r^2, in pairs, is off by at most 200u^2 (f^2 + r^2): as a share
// of s, 100u^2 (f^2 + r^2) q/(|c| sqrt(disc)) <= 2^-63, as q <= 2.5 sqrt(a r^2) where f^2 < 2r^2
// and q <= 2^20.1 sqrt(disc) otherwise; or, at q/a, 200u^2/t.
//
// All in all s is off by less than 2^-56 of itself before it is rounded: 0.63 ulp. Q = C - (T - s
// d) is made from the residual's vector and the unrounded s, and rounded once.
constexpr double kDiscriminantShare = 0x1p-10;
constexpr double kFarShare = 0x1p-40;
constexpr double kSurfaceShare = 0x1p-30;

template <class N>
struct Remainder {  ///< T - s0 d
  Rounded<N> x, y, z;
};

template <class N>
Rounded<N> remainder(const Rounded<N>& to_centre, N s, N direction) {
  const Rounded<N> product = two_product(s, direction);
  const Rounded<N> rest = two_difference(to_centre.x, product.x);
  return {rest.x, rest.error + (to_centre.error - product.error)};
}

/// |at|^2 - r^2
template <class N>
N residual(const Remainder<N>& at, N radius) {
  const N scale = N(2) * (radius * radius);
  const Rounded<N> xx = coarse_square(at.x.x, scale);
  const Rounded<N> yy = coarse_square(at.y.x, scale);
  const Rounded<N> zz = coarse_square(at.z.x, scale);
  const Rounded<N> rr = coarse_square(radius, scale);
  return (((xx.x + yy.x) + zz.x) - rr.x) +
         (((xx.error + yy.error) + (zz.error - rr.error)) +
          N(2) * (at.x.x * at.x.error + at.y.x * at.y.error + at.z.x * at.z.error));
}

template <class N>
struct Robust {
  using Number = N;

  static ChosenOf<N> answer(const Triple<N>& origin, const Triple<N>& direction,
                            const Triple<N>& centre, N radius, scene::Root root,
                            scene::Tangent tangent) {
    const Rounded<N> x = two_difference(centre.x, origin.x);
    const Rounded<N> y = two_difference(centre.y, origin.y);
    const Rounded<N> z = two_difference(centre.z, origin.z);
    const Triple<N> T = {x.x, y.x, z.x};
    const N a = dot(direction, direction);
    const N b = dot(T, direction);
    const N distance_sq = dot(T, T);
    const N radius_sq = radius * radius;
    const N size = distance_sq + radius_sq;
    const N c = distance_sq - radius_sq;
    const Triple<N> moment = cross(T, direction);
    const N discriminant = a * radius_sq - dot(moment, moment);
    const auto in_range =
        (smaller(size, a) > N(kLeastSquare)) & (larger(size, a) < N(kLargestSquare));
    const N doubt = a * (N(kDiscriminantShare) * radius_sq + N(kFarShare) * distance_sq);
    const auto certain =
        in_range & (absolute(discriminant) > doubt) & (absolute(c) > N(kSurfaceShare) * size);
    const auto outside = c > N(0);
    const auto forward = b >= N(0);
    const auto ahead = root == scene::Root::kNearest ? (!outside) | forward : outside & forward;
    const MaskOf<N> hit = certain & (discriminant > N(0)) & ahead;
    ChosenOf<N> chosen = {hit, N(0), {N(0), N(0), N(0)}};
    if (any(hit)) {
      const N half_slope = square_root(discriminant);  // of |T - s d|^2 at the root, but for sign
      const N q = absolute(b) + half_slope;
      const auto through_c = outside | !forward;
      const N s0 = select(through_c, absolute(c), q) / select(through_c, q, a);
      const Remainder<N> at = {remainder(x, s0, direction.x), remainder(y, s0, direction.y),
                               remainder(z, s0, direction.z)};
      const N correction = residual(at, radius) / (select(outside, N(-2), N(2)) * half_slope);
      chosen.parameter = s0 - correction;
      chosen.point = {coordinate(centre.x, at.x, correction * direction.x),
                      coordinate(centre.y, at.y, correction * direction.y),
                      coordinate(centre.z, at.z, correction * direction.z)};
    }
    if (any(!certain)) [[unlikely]] {
      answer_others(certain, origin, direction, centre, radius, root, tangent, chosen);
    }
    return chosen;
  }

 private:
  static N coordinate(N from, const Rounded<N>& rest, N shift) {
    const Rounded<N> point = two_difference(from, rest.x);
    return point.x + (point.error - (rest.error + shift));
  }

  /// Answers what the first step leaves open, one by one.
  static HWY_NOINLINE void answer_others(MaskOf<N> certain, const Triple<N>& origin,
                                         const Triple<N>& direction, const Triple<N>& centre,
                                         N radius, scene::Root root, scene::Tangent tangent,
                                         ChosenOf<N>& chosen) {
    constexpr std::size_t kCount = kLaneCount<N>;
    N number[] = {origin.x,
                  origin.y,
                  origin.z,
                  direction.x,
                  direction.y,
                  direction.z,
                  select(certain, N(1), N(0)),
                  select(chosen.hit, N(1), N(0)),
                  chosen.parameter,
                  chosen.point.x,
                  chosen.point.y,
                  chosen.point.z};
    double of[std::size(number)][kCount];
    double sphere[4][kCount];
    for (std::size_t k = 0; k < std::size(number); ++k) store(number[k], of[k]);
    store(centre.x, sphere[0]);
    store(centre.y, sphere[1]);
    store(centre.z, sphere[2]);
    store(radius, sphere[3]);
    for (std::size_t k = 0; k < kCount; ++k) {
      if (of[6][k] != 0) continue;
      const Chosen answer = answer_carefully(
          {{of[0][k], of[1][k], of[2][k]}, {of[3][k], of[4][k], of[5][k]}},
          {{sphere[0][k], sphere[1][k], sphere[2][k]}, sphere[3][k]}, root, tangent);
      of[7][k] = answer.hit ? 1 : 0;
      of[8][k] = answer.at.parameter;
      of[9][k] = answer.at.point.x;
      of[10][k] = answer.at.point.y;
      of[11][k] = answer.at.point.z;
    }
    for (std::size_t k = 0; k < std::size(number); ++k) load(of[k], number[k]);
    chosen = {number[7] > N(0), number[8], {number[9], number[10], number[11]}};
  }
};

bool batch(const BatchQuestion& question, const HitArrays& answers) {
  return answer_batch<Robust<Lanes>>(question, answers);
}

}  // namespace
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
namespace {

HWY_EXPORT(batch);

void intersect(const Rays& rays, const scene::Sphere& sphere, scene::Root root,
               scene::Tangent tangent, Hits& hits) {
  intersect_by(HWY_DYNAMIC_DISPATCH(batch), rays, sphere, root, tangent, hits);
}

}  // namespace

Chosen answer_carefully(const scene::Ray& ray, const scene::Sphere& sphere, scene::Root root,
                        scene::Tangent tangent) {
  if (const auto proven = answer_by_pairs(ray, sphere, root)) return *proven;
  return answer_by_integers(ray, sphere, root, tangent);
}

const IntersectMethod kRobust = {
    .name = "robust",
    .sentence = "cross corrected once in pairs of doubles where proven; else pairs, integers",
    .intersect = intersect,
    .intersect_one = HWY_NAMESPACE::intersect_one<HWY_NAMESPACE::Robust<double>>,
    .max_ulp = kRobustMaxUlp,
    .max_point_ulp = kRobustMaxPointUlp,
    .domain = kWideDomain,
    .exact_class = true,
};

}  // namespace raycheck::fast
#endif
