#include "fast/error_free.h"
#include "fast/intersect_batch.h"
#include "fast/robust.h"

namespace raycheck::fast {
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

/// T - s0 d and |T - s0 d|^2 - r^2.
struct Residual {
  Rounded x, y, z;
  double value;
};

Rounded remainder(const Rounded& to_centre, double s, double direction) {
  const Rounded product = two_product(s, direction);
  const Rounded rest = two_sum(to_centre.x, -product.x);
  return {rest.x, rest.error + (to_centre.error - product.error)};
}

Residual residual_at(double s, const Rounded& x, const Rounded& y, const Rounded& z,
                     const Vector3d& direction, double radius) {
  Residual at{remainder(x, s, direction.x()), remainder(y, s, direction.y()),
              remainder(z, s, direction.z()), 0};
  const Rounded xx = two_square(at.x.x);
  const Rounded yy = two_square(at.y.x);
  const Rounded zz = two_square(at.z.x);
  const Rounded rr = two_square(radius);
  const Rounded first = two_sum(xx.x, -rr.x);
  const Rounded second = two_sum(first.x, yy.x);
  const Rounded sum = two_sum(second.x, zz.x);
  at.value = sum.x + ((first.error + second.error + sum.error) +
                      ((xx.error + yy.error) + (zz.error - rr.error)) +
                      2 * (at.x.x * at.x.error + at.y.x * at.y.error + at.z.x * at.z.error));
  return at;
}

struct Robust {
  static Chosen answer(const Vector3d& origin, const Vector3d& direction, const Vector3d& centre,
                       double radius, scene::Root root, scene::Tangent tangent) {
    const Rounded x = two_sum(centre.x(), -origin.x());
    const Rounded y = two_sum(centre.y(), -origin.y());
    const Rounded z = two_sum(centre.z(), -origin.z());
    const Vector3d T(x.x, y.x, z.x);
    const double a = direction.dot(direction);
    const double b = T.dot(direction);
    const double distance_sq = T.dot(T);
    const double radius_sq = radius * radius;
    const double size = distance_sq + radius_sq;
    const double c = distance_sq - radius_sq;
    const Vector3d moment = T.cross(direction);
    const double share = a * radius_sq;
    const double discriminant = share - moment.dot(moment);
    const bool in_range =
        size > kLeastSquare && size < kLargestSquare && a > kLeastSquare && a < kLargestSquare;
    const bool certain =
        std::abs(discriminant) > kDiscriminantShare * share + kFarShare * (a * distance_sq) &&
        std::abs(c) > kSurfaceShare * size;
    if (!in_range || !certain) [[unlikely]] {
      return carefully(origin, direction, centre, radius, root, tangent);
    }
    const bool outside = c > 0;
    if (discriminant < 0 || (outside ? b < 0 : root == scene::Root::kSmaller)) return {};

    const double half_slope = std::sqrt(discriminant);  // of |T - s d|^2 at the root, but for sign
    const double q = std::abs(b) + half_slope;
    const double s0 = outside || b < 0 ? std::abs(c) / q : q / a;
    const Residual at = residual_at(s0, x, y, z, direction, radius);
    const double correction = at.value / (2 * (outside ? -half_slope : half_slope));
    const auto coordinate = [&](double from, const Rounded& rest, double along) {
      const Rounded point = two_sum(from, -rest.x);
      return point.x + (point.error - (rest.error + correction * along));
    };
    return {
        true,
        {s0 - correction,
         {coordinate(centre.x(), at.x, direction.x()), coordinate(centre.y(), at.y, direction.y()),
          coordinate(centre.z(), at.z, direction.z())}}};
  }

  [[gnu::noinline]] static Chosen carefully(const Vector3d& origin, const Vector3d& direction,
                                            const Vector3d& centre, double radius, scene::Root root,
                                            scene::Tangent tangent) {
    const scene::Ray ray = {plain<scene::Point3>(origin), plain<scene::Vector3>(direction)};
    const scene::Sphere sphere = {plain<scene::Point3>(centre), radius};
    if (const auto proven = answer_by_pairs(ray, sphere, root)) return *proven;
    return answer_by_integers(ray, sphere, root, tangent);
  }
};

}  // namespace

const IntersectMethod kRobust = {
    .name = "robust",
    .sentence = "cross corrected once in pairs of doubles where proven; else pairs, integers",
    .intersect = intersect_batch<Robust>,
    .intersect_one = intersect_one<Robust>,
    .max_ulp = kRobustMaxUlp,
    .max_point_ulp = kRobustMaxPointUlp,
    .domain = kWideDomain,
    .exact_class = true,
};

}  // namespace raycheck::fast
