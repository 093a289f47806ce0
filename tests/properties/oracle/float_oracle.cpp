#include "tests/properties/oracle/float_oracle.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace raycheck::tests {
namespace {

using Integer = mpz_class;

constexpr int kFloatDigits = 24;
constexpr long kLeastFloat = -149;  ///< The exponent of the least float.
/// Bits of a value below the last of a float: errors are that sharp.
constexpr long kGuard = 96;

Integer shifted(const Integer& x, long bits) {
  if (bits >= 0) return x << static_cast<mp_bitcnt_t>(bits);
  if (mpz_divisible_2exp_p(x.get_mpz_t(), static_cast<mp_bitcnt_t>(-bits)) == 0) {
    throw std::logic_error("bits are lost");
  }
  return x >> static_cast<mp_bitcnt_t>(-bits);
}

/// x 2^bits of a double, an integer.
Integer scaled(double x, long bits) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return shifted(Integer(std::ldexp(fraction, 53)), bits + exponent - 53);
}

/// The exponent of the last bit of a double that is not 0.
long last_bit(double x) {
  int exponent = 0;
  const Integer whole(std::ldexp(std::frexp(x, &exponent), 53));
  return static_cast<long>(mpz_scan1(whole.get_mpz_t(), 0)) + exponent - 53;
}

/// (rational + factor sqrt(radicand)) / denominator, denominator > 0.
struct Surd {
  Integer rational, factor, radicand, denominator;
};

int sign(const Surd& x) {
  const int of_rational = sgn(x.rational);
  const int of_root = sgn(x.factor) * sgn(x.radicand);
  if (of_root == 0 || of_rational == of_root) return of_rational;
  if (of_rational == 0) return of_root;
  const Integer difference = x.rational * x.rational - x.factor * x.factor * x.radicand;
  return sgn(difference) * of_rational;
}

/// floor(|x| 2^bits), and whether that is all of it.
struct Floor {
  Integer whole;
  bool is_exact;
};
Floor floor_of(Surd x, long bits) {
  if (sign(x) < 0) {
    x.rational = -x.rational;
    x.factor = -x.factor;
  }
  const auto up = static_cast<mp_bitcnt_t>(bits);
  const Integer rational = x.rational << up;
  const Integer square = (x.factor * x.factor * x.radicand) << (2 * up);
  Integer root, rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), square.get_mpz_t());
  // Below a root that is subtracted comes the next integer.
  const Integer top = sgn(x.factor) >= 0 ? Integer(rational + root)
                                         : Integer(rational - root - (rest == 0 ? 0 : 1));
  Integer quotient, remainder;
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), top.get_mpz_t(),
              x.denominator.get_mpz_t());
  return {quotient, rest == 0 && remainder == 0};
}

/// Bits that leave kGuard below the last bit of a float near x, which is not 0.
long bits_for(const Surd& x) {
  for (long bits = kGuard - kLeastFloat;; bits *= 2) {
    const Floor found = floor_of(x, bits);
    const auto length = static_cast<long>(mpz_sizeinbase(found.whole.get_mpz_t(), 2));
    if (found.whole != 0 && length > kFloatDigits + kGuard) return bits;
    if (bits > 20000) throw std::logic_error("too small for an oracle");
  }
}

/// The exponent of the gap between the floats around |x|, by floor(|x| 2^bits).
long gap_exponent(const Floor& floor, long bits) {
  const auto length = static_cast<long>(mpz_sizeinbase(floor.whole.get_mpz_t(), 2));
  return std::max(length - bits - kFloatDigits, kLeastFloat);
}

double nearest_float(const Surd& x) {
  const int of = sign(x);
  if (of == 0) return 0;
  const long bits = bits_for(x);
  const Floor floor = floor_of(x, bits);
  const long gap = gap_exponent(floor, bits);
  const auto below = static_cast<mp_bitcnt_t>(gap + bits);
  Integer count = floor.whole >> below;
  const Integer rest = floor.whole - (count << below);
  const Integer half = Integer(1) << (below - 1);
  const int side = cmp(rest, half);
  const bool is_above = side > 0 || (side == 0 && !floor.is_exact);
  const bool is_tie = side == 0 && floor.is_exact;
  if (is_above || (is_tie && mpz_odd_p(count.get_mpz_t()) != 0)) ++count;
  const double size = std::ldexp(count.get_d(), static_cast<int>(gap));
  return of * (size > std::numeric_limits<float>::max() ? std::numeric_limits<double>::infinity()
                                                        : size);
}

/// Both roots of |L + s d - C|^2 = r^2, in integers of one scale.
struct Pair {
  std::array<Integer, 3> L, d;
  Integer a, b, discriminant;
  long scale = 0;  ///< Lengths are integers times 2^-scale; s has no scale.

  Pair(const scene::Ray& ray, const scene::Sphere& sphere) {
    const double numbers[] = {ray.origin.x,    ray.origin.y,    ray.origin.z,    ray.direction.x,
                              ray.direction.y, ray.direction.z, sphere.centre.x, sphere.centre.y,
                              sphere.centre.z, sphere.radius};
    for (const double x : numbers) {
      if (x != 0) scale = std::max(scale, -last_bit(x));
    }
    std::array<Integer, 10> whole;
    for (std::size_t k = 0; k < 10; ++k) whole[k] = scaled(numbers[k], scale);
    Integer c = -whole[9] * whole[9];
    for (std::size_t k = 0; k < 3; ++k) {
      L[k] = whole[k];
      d[k] = whole[k + 3];
      const Integer T = whole[k + 6] - whole[k];
      a += d[k] * d[k];
      b += T * d[k];
      c += T * T;
    }
    discriminant = b * b - a * c;
  }
  Surd root(int which) const { return {b, which, discriminant, a}; }
  Surd point(int which, std::size_t k) const {
    return {L[k] * a + b * d[k], which * d[k], discriminant, a << static_cast<mp_bitcnt_t>(scale)};
  }
  /// -1 or 1: which root counts; 0: a miss.
  int chosen(scene::Root root_convention) const {
    if (discriminant < 0) return 0;
    if (sign(root(-1)) >= 0) return -1;
    return root_convention == scene::Root::kNearest && sign(root(1)) >= 0 ? 1 : 0;
  }
};

/// A value by 400 bits, of the sign that it has.
mpf_class value(const Surd& x) {
  if (sign(x) == 0) return mpf_class(0, 400);
  const long bits = bits_for(x);
  mpf_class result(floor_of(x, bits).whole, 400);
  mpf_div_2exp(result.get_mpf_t(), result.get_mpf_t(), static_cast<mp_bitcnt_t>(bits));
  return sign(x) < 0 ? mpf_class(-result) : result;
}

}  // namespace

FloatTruth float_truth(const scene::Ray& ray, const scene::Sphere& sphere, scene::Root root) {
  const Pair pair(ray, sphere);
  FloatTruth truth;
  truth.is_line_hit = pair.discriminant >= 0;
  truth.is_tangent = pair.discriminant == 0;
  const int which = pair.chosen(root);
  truth.is_hit = which != 0;
  if (!truth.is_hit) return truth;
  truth.s = nearest_float(pair.root(which));
  for (std::size_t k = 0; k < 3; ++k) truth.Q[k] = nearest_float(pair.point(which, k));
  return truth;
}

FloatErrors float_errors(const scene::Ray& ray, const scene::Sphere& sphere, scene::Root root,
                         double s, const scene::Point3& Q) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Pair pair(ray, sphere);
  const int which = pair.chosen(root);
  FloatErrors errors;
  const Surd exact = pair.root(which);
  const mpf_class exact_s = value(exact);
  const mpf_class off = abs(mpf_class(s, 400) - exact_s);
  if (pair.discriminant != 0) {
    const mpf_class other = value(pair.root(-which));
    errors.is_at_other_root =
        4 * abs(mpf_class(s, 400) - other) < abs(mpf_class(other - exact_s, 400));
  }
  if (sign(exact) == 0) {
    errors.s = s == 0 ? 0 : kInfinity;
  } else {
    const long bits = bits_for(exact);
    const long gap = gap_exponent(floor_of(exact, bits), bits);
    mpf_class ulps(off, 400);
    if (gap < 0) {
      mpf_mul_2exp(ulps.get_mpf_t(), ulps.get_mpf_t(), static_cast<mp_bitcnt_t>(-gap));
    } else {
      mpf_div_2exp(ulps.get_mpf_t(), ulps.get_mpf_t(), static_cast<mp_bitcnt_t>(gap));
    }
    errors.s = ulps.get_d();
  }
  const double given[] = {Q.x, Q.y, Q.z};
  mpf_class size_sq(0, 400), off_sq(0, 400);
  for (std::size_t k = 0; k < 3; ++k) {
    const mpf_class at = value(pair.point(which, k));
    const mpf_class apart = mpf_class(given[k], 400) - at;
    size_sq += at * at;
    off_sq += apart * apart;
  }
  if (size_sq == 0) {
    errors.Q = off_sq == 0 ? 0 : kInfinity;
  } else {
    const mpf_class share = sqrt(mpf_class(off_sq / size_sq, 400));
    errors.Q = std::ldexp(share.get_d(), kFloatDigits);
  }
  return errors;
}

}  // namespace raycheck::tests
