// The second step of `robust`: pairs of doubles.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/internal/robust_pairs.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "fast/internal/error_free.h"
#include "fast/internal/robust.h"
#include "fast/internal/triple.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

// a, f^2 + r^2 and products of two of these are in range: from 2^-300 to 2^304. Values that
// underflow, after products of low parts, are below 2^-1000, and negligible beside kPairMargin of
// these.
//
// b, c and disc are sums. Every term passes at most 8 operations, each off by at most
// kDoubleDoubleError = 2^-102 of its result, or, for a sum, of its operands (plus()). The sizes of
// the terms add up to at most f |d| for b, f^2 + r^2 for c and 2 a (f^2 + r^2) for disc. Therefore
// b is off by at most 2^-99 f |d|, c by 2^-99 (f^2 + r^2), disc by 2^-98 a (f^2 + r^2). Signs are
// certain beyond twice these bounds.
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

/// c from exact products, in two passes of error-free sums. Needed if the origin is so near the
/// surface that pairs of doubles lose too many digits.
HWY_INLINE Rounded<Lanes> long_sum_c(const Triple<Rounded<Lanes>>& to_centre, const Lanes& radius) {
  Lanes terms[17];
  std::size_t count = 0;
  const auto add = [&](const Rounded<Lanes>& product) {
    terms[count++] = product.x;
    terms[count++] = product.error;
  };
  const auto add_square = [&](const Rounded<Lanes>& x) {
    add(two_square(x.x));
    add(two_product(Lanes(2.0) * x.x, x.error));
    terms[count++] = x.error * x.error;
  };
  add_square(to_centre.x);
  add_square(to_centre.y);
  add_square(to_centre.z);
  add(-two_square(radius));
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t k = 1; k < 17; ++k) {
      const Rounded<Lanes> sum = two_sum(terms[k], terms[k - 1]);
      terms[k] = sum.x;
      terms[k - 1] = sum.error;
    }
  }
  Lanes low(0.0);
  for (std::size_t k = 0; k < 16; ++k) low = low + terms[k];
  return two_sum(terms[16], low);
}

/// x + y in 11 operations instead of 20 (SloppyDWPlusDW): off by at most 4 u^2 (|x| + |y|), from
/// the roundings of two sums of low parts.
HWY_INLINE Rounded<Lanes> plus(const Rounded<Lanes>& x, const Rounded<Lanes>& y) {
  const Rounded<Lanes> high = two_sum(x.x, y.x);
  return fast_two_sum(high.x, high.error + (x.error + y.error));
}
HWY_INLINE Rounded<Lanes> minus(const Rounded<Lanes>& x, const Rounded<Lanes>& y) {
  return plus(x, -y);
}
HWY_INLINE Rounded<Lanes> sum_of(const Triple<Rounded<Lanes>>& x) {
  return plus(plus(x.x, x.y), x.z);
}
/// A product with a number, off by at most 3 u^2 of it (DWTimesFP2).
HWY_INLINE Rounded<Lanes> times(const Rounded<Lanes>& x, const Lanes& y) {
  const Rounded<Lanes> high = two_product(x.x, y);
  return fast_two_sum(high.x, mul_add(x.error, y, high.error));
}
/// A square, off by at most 7 u^2 of it.
HWY_INLINE Rounded<Lanes> squared(const Rounded<Lanes>& x) {
  const Rounded<Lanes> high = two_square(x.x);
  return fast_two_sum(high.x, mul_add(Lanes(2.0) * x.x, x.error, high.error));
}
HWY_INLINE Triple<Rounded<Lanes>> squares(const Triple<Rounded<Lanes>>& v) {
  return {squared(v.x), squared(v.y), squared(v.z)};
}

HWY_INLINE Rounded<Lanes> select(LaneMask condition, const Rounded<Lanes>& yes,
                                 const Rounded<Lanes>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.error, no.error)};
}
HWY_INLINE Rounded<Lanes> absolute(const Rounded<Lanes>& x) {
  return select(x.x < Lanes(0.0), -x, x);
}

HWY_INLINE Triple<Rounded<Lanes>> load_pairs(const double (&x)[3][PairBlock::kSize],
                                             const double (&rest)[3][PairBlock::kSize],
                                             std::size_t k) {
  return {{load(x[0] + k), load(rest[0] + k)},
          {load(x[1] + k), load(rest[1] + k)},
          {load(x[2] + k), load(rest[2] + k)}};
}
HWY_INLINE void store_bytes(LaneMask mask, std::uint8_t byte, std::uint8_t* to) {
  const std::uint64_t bytes = byte * kBytesOfBits[bits(mask)];
  std::uint64_t before = 0;
  std::memcpy(&before, to, kLaneCount);
  before |= bytes;
  std::memcpy(to, &before, kLaneCount);
}

template <bool kPrecise>
void pairs_of_block(std::size_t count, scene::Root root, PairBlock& block) {
  const Lanes zero(0.0);
  for (std::size_t k = 0; k < count; k += kLaneCount) {
    const Triple<Rounded<Lanes>> T = load_pairs(block.to_centre, block.rest, k);
    const Triple<Lanes> d = {load(block.direction[0] + k), load(block.direction[1] + k),
                             load(block.direction[2] + k)};
    const Lanes r = load(block.radius + k);
    const Rounded<Lanes> radius_sq = two_square(r);
    const Rounded<Lanes> distance_sq = sum_of(squares(T));
    const Lanes size = distance_sq.x + radius_sq.x;
    Rounded<Lanes> c = minus(distance_sq, radius_sq);
    const LaneMask first_is_precise = absolute(c.x) > Lanes(kPreciseC) * size;
    LaneMask c_is_precise = first_is_precise, c_is_known = first_is_precise;
    if (!all(c_is_precise)) {
      c = select(c_is_precise, c, long_sum_c(T, r));
      c_is_known = c_is_known | (absolute(c.x) > Lanes(kLongSumMargin) * size);
      c_is_precise = c_is_precise | (absolute(c.x) > Lanes(kPreciseLongSum) * size);
    }
    const LaneMask outside = c.x > zero;
    const Rounded<Lanes> b = sum_of({times(T.x, d.x), times(T.y, d.y), times(T.z, d.z)});
    const LaneMask backward = b.x < zero;
    // Right even if the sign of b is uncertain: then b^2 < (2^-98 f |d|)^2 < a c, so disc < 0.
    LaneMask miss = outside & backward;
    if (root == scene::Root::kSmaller) miss = miss | !outside;
    const Rounded<Lanes> a = sum_of({two_square(d.x), two_square(d.y), two_square(d.z)});
    const Triple<Rounded<Lanes>> moment = {minus(times(T.y, d.z), times(T.z, d.y)),
                                           minus(times(T.z, d.x), times(T.x, d.z)),
                                           minus(times(T.x, d.y), times(T.y, d.x))};
    const Rounded<Lanes> discriminant = minus(a * radius_sq, sum_of(squares(moment)));
    const Lanes margin = Lanes(kPairMargin) * (a.x * size);
    const LaneMask has_sign = absolute(discriminant.x) > margin;
    miss = c_is_known & (miss | (has_sign & (discriminant.x < zero)));

    const Rounded<Lanes> discriminant_root = pair_root(discriminant);
    const Rounded<Lanes> q = plus(absolute(b), discriminant_root);
    const LaneMask through_c = outside | backward;
    // The error of disc, through the square root, must be within the share of q. Then q > 2^-20 of
    // its largest, so that the error of b is within the share, too.
    const LaneMask hit = c_is_known & has_sign & (discriminant.x > zero) & !miss &
                         (margin < Lanes(kPreciseShare) * (discriminant_root.x * q.x)) &
                         (c_is_precise | !through_c);
    const Rounded<Lanes> s = select(through_c, absolute(c), q) / select(through_c, q, a);
    const Triple<Rounded<Lanes>> from_point = {minus(T.x, times(s, d.x)), minus(T.y, times(s, d.y)),
                                               minus(T.z, times(s, d.z))};  // C - Q
    std::memset(block.code + k, 0, kLaneCount);
    store_bytes(hit, kHit, block.code + k);
    store_bytes(hit & !outside, kLargerRoot, block.code + k);
    store_bytes(!(hit | miss), kOpen, block.code + k);
    if constexpr (kPrecise) {
      // The error of q is at most margin/2 through sqrt(disc), and through b; a, the quotient and
      // sums add less than 2^-99.
      const Lanes of_c = select(first_is_precise, Lanes(0x1p-99), Lanes(0x1p-146)) * size;
      const Lanes share = margin / (discriminant_root.x * q.x) + Lanes(0x1p-97);
      store(select(through_c, share + of_c / absolute(c.x), share), block.share + k);
      store((discriminant_root.x + discriminant_root.x) / a.x, block.chord + k);
      store(s.error, block.s_rest + k);
    }
    store(s.x, block.s + k);
    store(Triple<Lanes>{from_point.x.x, from_point.y.x, from_point.z.x},
          {block.from_point[0], block.from_point[1], block.from_point[2]}, k);
    store(Triple<Lanes>{from_point.x.error, from_point.y.error, from_point.z.error},
          {block.from_rest[0], block.from_rest[1], block.from_rest[2]}, k);
  }
}

void pairs_of_answers(std::size_t count, scene::Root root, PairBlock& block) {
  pairs_of_block<false>(count, root, block);
}
void precise_pairs(std::size_t count, scene::Root root, PairBlock& block) {
  pairs_of_block<true>(count, root, block);
}

}  // namespace
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
namespace {

HWY_EXPORT(pairs_of_answers);
HWY_EXPORT(precise_pairs);

using HWY_NAMESPACE::Rounded;
using HWY_NAMESPACE::two_sum;

/// Lengths between these need no scaling, nor do directions.
constexpr double kLeastPlain = 0x1p-150, kMostPlain = 0x1p150;

/// The power of two that scales a positive number to [1, 2), if it must be scaled.
int exponent_of(double size) {
  return size >= kLeastPlain && size <= kMostPlain ? 0 : std::ilogb(size);
}

/// 2^exponent as a product of two doubles: multiplying by them is much faster than std::ldexp, and
/// as exact unless the result is subnormal.
struct PowerOfTwo {
  double half, other;
  explicit PowerOfTwo(int exponent) : half(of(exponent / 2)), other(of(exponent - exponent / 2)) {}
  void scale(double (&values)[3][PairBlock::kSize], std::size_t k) const {
    for (auto& one : values) one[k] = one[k] * half * other;
  }

 private:
  static double of(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
  }
};

double most(const double (&values)[3][PairBlock::kSize], std::size_t k) {
  return std::max({std::abs(values[0][k]), std::abs(values[1][k]), std::abs(values[2][k])});
}

}  // namespace

bool PairBlock::put(std::size_t k, const scene::Ray& ray, const scene::Sphere& sphere) {
  const scene::Point3 &o = ray.origin, &C = sphere.centre;
  const scene::Vector3& d = ray.direction;
  const auto set = [&](double factor) {
    const Rounded<double> x = two_sum(factor * C.x, factor * -o.x);
    const Rounded<double> y = two_sum(factor * C.y, factor * -o.y);
    const Rounded<double> z = two_sum(factor * C.z, factor * -o.z);
    to_centre[0][k] = x.x, to_centre[1][k] = y.x, to_centre[2][k] = z.x;
    rest[0][k] = x.error, rest[1][k] = y.error, rest[2][k] = z.error;
    radius[k] = factor * sphere.radius;
  };
  set(1);
  int lengths = 0;
  if (!std::isfinite(most(to_centre, k))) {  // so large that dividing by 4 loses nothing
    lengths = 2;
    set(0.25);
  }
  direction[0][k] = d.x, direction[1][k] = d.y, direction[2][k] = d.z;
  const double length = std::max(most(to_centre, k), radius[k]), width = most(direction, k);
  centre[k] = C;
  if (!(length > 0 && length < HUGE_VAL && width > 0 && width < HUGE_VAL)) return false;
  const int shift = exponent_of(length), turn = exponent_of(width);
  if (shift != 0) {
    const PowerOfTwo less(-shift);
    less.scale(to_centre, k);
    less.scale(rest, k);
    radius[k] = radius[k] * less.half * less.other;
  }
  if (turn != 0) PowerOfTwo(-turn).scale(direction, k);
  length_exponent[k] = lengths + shift;
  exponent[k] = length_exponent[k] - turn;
  return true;
}

void PairBlock::answer(std::size_t count, scene::Root root, bool is_precise) {
  const std::size_t whole = (count + 7) / 8 * 8;  // the most lanes
  const auto fill = [&](double* values) {
    for (std::size_t k = count; k < whole; ++k) values[k] = values[count - 1];
  };
  for (int axis = 0; axis < 3; ++axis) {
    fill(to_centre[axis]);
    fill(rest[axis]);
    fill(direction[axis]);
  }
  fill(radius);
  if (is_precise) return HWY_DYNAMIC_DISPATCH(precise_pairs)(count, root, *this);
  HWY_DYNAMIC_DISPATCH(pairs_of_answers)(count, root, *this);
}

Decided PairBlock::at(std::size_t k) const {
  if ((code[k] & kHit) == 0) return {code[k], {}};
  const auto coordinate = [&](int axis, double c) {  // Q = C - (T - s d)
    Rounded<double> from = {from_point[axis][k], from_rest[axis][k]};
    if (length_exponent[k] != 0) {
      from = {std::ldexp(from.x, length_exponent[k]), std::ldexp(from.error, length_exponent[k])};
    }
    const double point = c - from.x;  // an infinity if Q is out of range
    return std::isfinite(point) ? (Rounded<double>{c, 0.0} - from).x : point;
  };
  const auto& [x, y, z] = centre[k];
  return {code[k],
          {exponent[k] == 0 ? s[k] : std::ldexp(s[k], exponent[k]),
           {coordinate(0, x), coordinate(1, y), coordinate(2, z)}}};
}

namespace {

bool is_valid(const scene::Ray& ray, const scene::Sphere& sphere) {
  const auto& [o, d] = ray;
  const auto& [c, r] = sphere;
  // x - x is 0 for a finite x, else NaN.
  const double sum = ((o.x - o.x) + (o.y - o.y)) + ((o.z - o.z) + (d.x - d.x)) +
                     ((d.y - d.y) + (d.z - d.z)) + ((c.x - c.x) + (c.y - c.y)) +
                     ((c.z - c.z) + (r - r));
  return sum == 0 && r >= 0 && d != scene::Vector3{};
}

}  // namespace

void settle(const BatchInput& input, const HitArrays& to, bool has_roots) {
  PairBlock block;
  std::size_t places[PairBlock::kSize];
  std::size_t waiting = 0;
  const auto set = [&](std::size_t k, const Decided& decided) {
    to.hit[k] = has_roots ? decided.code : decided.code & kHit;
    if (decided.code == kMiss) return;
    to.parameter[k] = decided.at.parameter;
    to.point[0][k] = decided.at.point.x;
    to.point[1][k] = decided.at.point.y;
    to.point[2][k] = decided.at.point.z;
  };
  const auto by_integers = [&](std::size_t k) {
    set(k, answer_by_integers(input.ray(k), input.sphere_of(k), input.rule));
  };
  const auto flush = [&] {
    if (waiting == 0) return;
    block.answer(waiting, input.rule.root);
    for (std::size_t n = 0; n < waiting; ++n) {
      block.code[n] == kOpen ? by_integers(places[n]) : set(places[n], block.at(n));
    }
    waiting = 0;
  };
  std::uint8_t* const last = to.hit + input.count;
  for (std::uint8_t* open = to.hit; open != last; ++open) {
    // Faster than std::find, which compares byte by byte.
    open =
        static_cast<std::uint8_t*>(std::memchr(open, kOpen, static_cast<std::size_t>(last - open)));
    if (open == nullptr) break;
    const auto k = static_cast<std::size_t>(open - to.hit);
    const scene::Ray ray = input.ray(k);
    const scene::Sphere sphere = input.sphere_of(k);
    if (!is_valid(ray, sphere)) continue;
    if (!block.put(waiting, ray, sphere)) {
      by_integers(k);
      continue;
    }
    places[waiting++] = k;
    if (waiting == PairBlock::kSize) flush();
  }
  flush();
}

void precise_hits(const BatchInput& input, std::span<const std::uint32_t> rays, PreciseHit* hits) {
  PairBlock block;
  for (std::size_t first = 0; first < rays.size(); first += PairBlock::kSize) {
    const auto some = rays.subspan(first, std::min(PairBlock::kSize, rays.size() - first));
    for (std::size_t k = 0; k < some.size(); ++k) {
      block.put(k, input.ray(some[k]), input.sphere_of(some[k]));
    }
    block.answer(some.size(), input.rule.root, true);
    for (std::size_t k = 0; k < some.size(); ++k, ++hits) {
      const bool is_known =
          (block.code[k] & kHit) != 0 && block.length_exponent[k] == 0 && block.exponent[k] == 0;
      const auto at = [&](const auto& of) { return scene::Point3{of[0][k], of[1][k], of[2][k]}; };
      *hits = {block.s[k],         block.s_rest[k],     is_known ? block.share[k] : HUGE_VAL,
               block.chord[k],     at(block.to_centre), at(block.from_point),
               at(block.from_rest)};
    }
  }
}

std::optional<Decided> answer_by_pairs(const scene::Ray& ray, const scene::Sphere& sphere,
                                       scene::Root root) {
  PairBlock block;
  if (!block.put(0, ray, sphere)) return std::nullopt;
  block.answer(1, root);
  return block.code[0] == kOpen ? std::nullopt : std::optional(block.at(0));
}

}  // namespace raycheck::fast
#endif
