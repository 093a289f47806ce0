#include <gmp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "fast/internal/robust.h"

namespace raycheck::fast {
namespace {

class Integer {
 public:
  Integer() { mpz_init2(value_, 1024); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { mpz_clear(value_); }

  operator mpz_ptr() { return value_; }           // NOLINT: for calls of GMP
  operator mpz_srcptr() const { return value_; }  // NOLINT: for calls of GMP
  int sign() const { return mpz_sgn(value_); }
  long bits() const { return static_cast<long>(mpz_sizeinbase(value_, 2)); }

 private:
  mpz_t value_;
};

/// Integers whose memory is kept between rays.
struct Scratch {
  std::array<Integer, 3> origin, direction, to_centre;
  Integer radius, a, b, c, discriminant, root, rest, numerator, denominator, parameter, point;
};

/// significand 2^exponent; 0 is 0 2^kNoExponent.
struct Dyadic {
  std::int64_t significand;
  int exponent;
};
constexpr int kNoExponent = 10000;

/// A finite x as a Dyadic with an odd significand.
Dyadic dyadic(double x) {
  if (x == 0) return {0, kNoExponent};
  int exponent = 0;
  const auto significand = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(significand));
  return {significand >> zeros, exponent - 53 + zeros};
}

/// Divides the values by 2^e, e the least of their exponents, and sets the integers to the
/// quotients. Returns e.
template <std::size_t kCount>
int set(const std::array<Integer*, kCount>& integers, const std::array<double, kCount>& values) {
  std::array<Dyadic, kCount> numbers;
  int least = kNoExponent;
  for (std::size_t k = 0; k < kCount; ++k) {
    numbers[k] = dyadic(values[k]);
    least = std::min(least, numbers[k].exponent);
  }
  for (std::size_t k = 0; k < kCount; ++k) {
    mpz_set_si(*integers[k], numbers[k].significand);
    if (numbers[k].significand == 0) continue;
    mpz_mul_2exp(*integers[k], *integers[k], static_cast<mp_bitcnt_t>(numbers[k].exponent - least));
  }
  return least;
}

/// The double nearest to x 2^exponent, ties to even; `inexact` means that the true magnitude is
/// slightly larger. Overflows to infinity.
double nearest_double(const Integer& x, long exponent, bool inexact, Integer& scratch) {
  if (x.sign() == 0) return 0;
  const long excess = x.bits() - 64;  // beyond the top 64 bits
  if (excess >= 0) {
    mpz_tdiv_q_2exp(scratch, x, static_cast<mp_bitcnt_t>(excess));
    inexact |= mpz_scan1(x, 0) < static_cast<mp_bitcnt_t>(excess);
  } else {
    mpz_mul_2exp(scratch, x, static_cast<mp_bitcnt_t>(-excess));
  }
  const std::uint64_t upper = mpz_get_ui(scratch);
  const long least = exponent + excess;
  const long dropped = std::max(11L, -1074 - least);
  if (dropped > 64) return x.sign() < 0 ? -0.0 : 0.0;
  const std::uint64_t kept = dropped == 64 ? 0 : upper >> dropped;
  const std::uint64_t below = dropped == 64 ? upper : upper & ((std::uint64_t{1} << dropped) - 1);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  const bool up = below > half || (below == half && (inexact || (kept & 1) != 0));
  const double rounded = static_cast<double>(kept + (up ? 1 : 0));
  return std::ldexp(x.sign() < 0 ? -rounded : rounded, static_cast<int>(least + dropped));
}

/// c = |T|^2 - r^2, b = T.d and a = |d|^2.
void set_coefficients(Scratch& n) {
  mpz_mul(n.c, n.radius, n.radius);
  mpz_neg(n.c, n.c);
  mpz_set_ui(n.a, 0);
  mpz_set_ui(n.b, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    mpz_sub(n.to_centre[k], n.to_centre[k], n.origin[k]);
    mpz_addmul(n.a, n.direction[k], n.direction[k]);
    mpz_addmul(n.b, n.direction[k], n.to_centre[k]);
    mpz_addmul(n.c, n.to_centre[k], n.to_centre[k]);
  }
}

/// Square roots and quotients have at least this many bits.
constexpr long kBits = 128;

/// Sets numerator / denominator to the root that counts; returns whether it is exact. Domain: disc
/// >= 0.
bool set_fraction(Scratch& n) {
  // The root is sqrt(disc) 2^shift rounded down, and has at least kBits bits.
  const long shift = std::max(0L, kBits + 1 - n.discriminant.bits() / 2);
  mpz_mul_2exp(n.discriminant, n.discriminant, static_cast<mp_bitcnt_t>(2 * shift));
  mpz_sqrtrem(n.root, n.rest, n.discriminant);
  const bool through_c = n.c.sign() > 0 || n.b.sign() < 0;
  mpz_abs(n.b, n.b);
  mpz_mul_2exp(n.b, n.b, static_cast<mp_bitcnt_t>(shift));
  Integer& q = through_c ? n.denominator : n.numerator;
  Integer& other = through_c ? n.numerator : n.denominator;
  mpz_add(q, n.b, n.root);
  mpz_abs(other, through_c ? n.c : n.a);
  mpz_mul_2exp(other, other, static_cast<mp_bitcnt_t>(shift));
  return n.rest.sign() == 0;
}

std::uint8_t code_of(bool larger_root, bool is_tangent) {
  return kHit | (larger_root ? kLargerRoot : 0) | (is_tangent ? kTangentRay : 0);
}

template <class Triple>
bool is_finite(const Triple& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

Decided answer_by_integers(const scene::Ray& ray, const scene::Sphere& sphere,
                           scene::HitRule rule) {
  const Decided miss{};
  const auto& [origin, direction] = ray;
  const auto& [centre, radius] = sphere;
  if (!is_finite(origin) || !is_finite(direction) || !is_finite(centre) || !std::isfinite(radius)) {
    return miss;
  }
  thread_local Scratch n;
  const int length_exponent =
      set<7>({&n.origin[0], &n.origin[1], &n.origin[2], &n.to_centre[0], &n.to_centre[1],
              &n.to_centre[2], &n.radius},
             {origin.x, origin.y, origin.z, centre.x, centre.y, centre.z, radius});
  const int direction_exponent = set<3>({&n.direction[0], &n.direction[1], &n.direction[2]},
                                        {direction.x, direction.y, direction.z});
  set_coefficients(n);
  const int c = n.c.sign();
  const int b = n.b.sign();
  const bool larger_counts = rule.root == scene::Root::kNearest;
  if (n.a.sign() == 0 || (c < 0 && !larger_counts) || (c > 0 && b <= 0)) return miss;
  if (c == 0) {  // roots 0 and 2b/a
    const bool met =
        b > 0 || (b < 0 && larger_counts) || (b == 0 && rule.tangent != scene::Tangent::kMiss);
    if (!met) return miss;
    return {code_of(b < 0, b == 0), {0, origin}};
  }
  mpz_mul(n.discriminant, n.b, n.b);
  mpz_submul(n.discriminant, n.a, n.c);
  if (n.discriminant.sign() < 0) return miss;
  const bool is_tangent = n.discriminant.sign() == 0;
  if (is_tangent && rule.tangent == scene::Tangent::kMiss) return miss;

  bool exact = set_fraction(n);
  const long shift = std::max(0L, kBits + n.denominator.bits() - n.numerator.bits());
  mpz_mul_2exp(n.numerator, n.numerator, static_cast<mp_bitcnt_t>(shift));
  mpz_tdiv_qr(n.parameter, n.rest, n.numerator, n.denominator);
  exact = exact && n.rest.sign() == 0;
  Decided chosen{code_of(c < 0, is_tangent)};
  chosen.at.parameter =
      nearest_double(n.parameter, length_exponent - direction_exponent - shift, !exact, n.rest);
  const auto coordinate = [&](std::size_t k) {
    mpz_mul_2exp(n.point, n.origin[k], static_cast<mp_bitcnt_t>(shift));
    mpz_addmul(n.point, n.parameter, n.direction[k]);
    return nearest_double(n.point, length_exponent - shift, false, n.rest);
  };
  chosen.at.point = {coordinate(0), coordinate(1), coordinate(2)};
  return chosen;
}

}  // namespace raycheck::fast
