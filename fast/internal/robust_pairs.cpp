#include <algorithm>
#include <array>
#include <cmath>

#include "fast/internal/double_double.h"
#include "fast/internal/eigen.h"
#include "fast/internal/robust.h"

namespace raycheck::fast {
namespace {

// After scaling, max(|T_i|, r) and max |d_i| lie in [1, 2), so that f^2 + r^2 < 16, a < 12 and f
// |d| < 12. Values that then underflow are below 2^-1000 and negligible.
//
// b, c and disc are sums. Every term passes at most 8 operations, each off by at most
// kDoubleDoubleError = 2^-102 of its result. The sizes of the terms add up to at most f |d| for b,
// f^2 + r^2 for c and 2 a (f^2 + r^2) for disc. Therefore b is off by at most 2^-99 f |d|, c by
// 2^-99 (f^2 + r^2), disc by 2^-98 a (f^2 + r^2). Signs are certain beyond twice these bounds.
constexpr double kPairMargin = 0x1p-97;

/// s = |c|/q or q/a is precise if its parts are off by at most this share. With the remaining
/// operations and the rounding to double, s is then off by at most 0.6 ulp; by 0.8 ulp if it is
/// subnormal and therefore rounded twice.
constexpr double kPreciseShare = 0x1p-58;
/// c is precise enough for s if |c| is above this share of f^2 + r^2.
constexpr double kPreciseC = kPairMargin / kPreciseShare;

/// For long_sum_c(), a sum of 17 terms whose magnitudes add up to f^2 + r^2. A pass leaves errors
/// of at most 16 u times the magnitudes before it. Two passes leave 2^-49 of the sum and 2^-97 (f^2
/// + r^2); the plain summation at the end loses 2^-49 of these. Together the sum is off by 2^-98 of
/// itself and 2^-146 (f^2 + r^2). (Ogita, Rump and Oishi, Accurate sum and dot product, 2005:
/// SumK.)
constexpr double kLongSumMargin = 0x1p-142;
constexpr double kPreciseLongSum = kLongSumMargin / kPreciseShare;

using Eigen::Vector3d;
using Pair3 = Eigen::Matrix<DoubleDouble, 3, 1>;

/// c from exact products, in two passes of error-free sums. Needed if the origin is so near the
/// surface that pairs of doubles lose too many digits.
DoubleDouble long_sum_c(const Pair3& to_centre, double radius) {
  std::array<double, 17> terms;
  std::size_t count = 0;
  const auto add = [&](const Rounded& product) {
    terms[count++] = product.x;
    terms[count++] = product.error;
  };
  for (const DoubleDouble& x : {to_centre.x(), to_centre.y(), to_centre.z()}) {
    add(two_square(x.high));
    add(two_product(2 * x.high, x.low));
    terms[count++] = x.low * x.low;
  }
  const Rounded radius_sq = two_square(radius);
  add({-radius_sq.x, -radius_sq.error});
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t k = 1; k < terms.size(); ++k) {
      const Rounded sum = two_sum(terms[k], terms[k - 1]);
      terms[k] = sum.x;
      terms[k - 1] = sum.error;
    }
  }
  double low = 0;
  for (std::size_t k = 0; k + 1 < terms.size(); ++k) low += terms[k];
  return two_sum(terms.back(), low);
}

DoubleDouble scaled(const DoubleDouble& x, int exponent) {
  return Rounded{std::ldexp(x.high, exponent), std::ldexp(x.low, exponent)};
}
Pair3 scaled(const Pair3& v, int exponent) {
  return {scaled(v.x(), exponent), scaled(v.y(), exponent), scaled(v.z(), exponent)};
}

double largest(const Pair3& v) {
  return std::max({std::abs(v.x().high), std::abs(v.y().high), std::abs(v.z().high)});
}

/// centre - origin, as exact pairs.
Pair3 difference(const Vector3d& centre, const Vector3d& origin) {
  return {two_sum(centre.x(), -origin.x()), two_sum(centre.y(), -origin.y()),
          two_sum(centre.z(), -origin.z())};
}

DoubleDouble absolute(const DoubleDouble& x) { return x.high < 0 ? -x : x; }

}  // namespace

std::optional<Decided> answer_by_pairs(const scene::Ray& ray, const scene::Sphere& sphere,
                                       scene::Root root) {
  const Decided miss{};
  const Vector3d origin = eigen(ray.origin);
  const Vector3d centre = eigen(sphere.centre);
  double radius = sphere.radius;
  Pair3 T = difference(centre, origin);
  int length_exponent = 0;
  if (!std::isfinite(largest(T))) {  // so large that dividing by 4 loses nothing
    length_exponent = 2;
    T = difference(centre / 4, origin / 4);
    radius /= 4;
  }
  const Pair3 given_direction = eigen(ray.direction).cast<DoubleDouble>();
  const double length = std::max(largest(T), radius);
  const double direction_size = largest(given_direction);
  if (!(length > 0 && std::isfinite(length) && direction_size > 0 &&
        std::isfinite(direction_size))) {
    return std::nullopt;
  }
  const int length_shift = std::ilogb(length);
  length_exponent += length_shift;
  T = scaled(T, -length_shift);
  const double r = std::ldexp(radius, -length_shift);
  const int direction_exponent = std::ilogb(direction_size);
  const Pair3 d = scaled(given_direction, -direction_exponent);

  const DoubleDouble radius_sq = two_square(r);
  const DoubleDouble distance_sq = T.dot(T);
  const double size = distance_sq.high + radius_sq.high;
  DoubleDouble c = distance_sq - radius_sq;
  bool c_is_precise = std::abs(c.high) > kPreciseC * size;
  if (!c_is_precise) {
    c = long_sum_c(T, r);
    c_is_precise = std::abs(c.high) > kPreciseLongSum * size;
    if (!(std::abs(c.high) > kLongSumMargin * size)) return std::nullopt;
  }
  const bool outside = c.high > 0;
  if (!outside && root == scene::Root::kSmaller) return miss;
  const DoubleDouble b = T.dot(d);
  // Right even if the sign of b is uncertain: then b^2 < (12 2^-98)^2 < a c, so disc < 0.
  if (outside && b.high < 0) return miss;
  const DoubleDouble a = d.dot(d);
  const Pair3 moment = T.cross(d);
  const DoubleDouble discriminant = a * radius_sq - moment.dot(moment);
  const double margin = kPairMargin * (a.high * size);
  if (!(std::abs(discriminant.high) > margin)) return std::nullopt;
  if (discriminant.high < 0) return miss;

  const DoubleDouble discriminant_root = sqrt(discriminant);
  const DoubleDouble q = absolute(b) + discriminant_root;
  // The error of disc, through the square root, must be within the share of q. Then q > 2^-20, so
  // that the error of b is within the share, too.
  if (!(margin < kPreciseShare * (discriminant_root.high * q.high))) return std::nullopt;
  const bool through_c = outside || b.high < 0;
  if (through_c && !c_is_precise) return std::nullopt;
  const DoubleDouble s = through_c ? absolute(c) / q : q / a;
  const auto coordinate = [&](int k) {  // Q = C - (T - s d)
    const DoubleDouble from_point = scaled(T[k] - s * d[k], length_exponent);
    const double point = centre[k] - from_point.high;  // an infinity if Q is out of range
    if (!std::isfinite(point)) return point;
    return static_cast<double>(DoubleDouble(centre[k]) - from_point);
  };
  return Decided{outside ? kHit : static_cast<std::uint8_t>(kHit | kLargerRoot),
                 {std::ldexp(s.high, length_exponent - direction_exponent),
                  {coordinate(0), coordinate(1), coordinate(2)}}};
}

}  // namespace raycheck::fast
