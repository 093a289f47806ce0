#include "tests/properties/oracle/float_oracle.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <limits>

#include "tests/numbers.h"

namespace raycheck::tests {
namespace {

/// About 6600 bits, in which products of four floats' sums are exact; so are square roots and
/// quotients that floats, and what lies halfway between two of them, are equal to.
using Wide = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<2000>,
                                           boost::multiprecision::et_off>;

constexpr int kFloatDigits = 24;
constexpr int kLeastFloat = -149;  ///< The exponent of the least float.

/// The exponent of the gap between the floats around x, which is not 0.
int gap_exponent(const Wide& x) {
  int exponent = 0;
  frexp(x, &exponent);
  return std::max(exponent - kFloatDigits, kLeastFloat);
}

/// x in gaps between floats around `at`; 0 of 0, infinite of 0 otherwise.
double in_gaps(const Wide& x, const Wide& at) {
  if (at == 0) return x == 0 ? 0 : kInfinity;
  return Wide(ldexp(x, -gap_exponent(at))).convert_to<double>();
}

double nearest_float(const Wide& x) {
  if (x == 0) return 0;
  const int gap = gap_exponent(x);
  const Wide count = abs(Wide(ldexp(x, -gap)));
  Wide whole = floor(count);
  const Wide rest = count - whole, half = Wide(1) / 2;
  const bool is_odd = floor(whole / 2) * 2 != whole;
  if (rest > half || (rest == half && is_odd)) whole += 1;
  const double size = std::ldexp(whole.convert_to<double>(), gap);
  const bool overflows = size > static_cast<double>(std::numeric_limits<float>::max());
  return (x < 0 ? -1 : 1) * (overflows ? kInfinity : size);
}

/// Both roots of |L + s d - C|^2 = r^2.
struct Pair {
  std::array<Wide, 3> L, d;
  Wide a = 0, b = 0, c, discriminant;

  Pair(const scene::Ray& ray, const scene::Sphere& sphere)
      : L{ray.origin.x, ray.origin.y, ray.origin.z},
        d{ray.direction.x, ray.direction.y, ray.direction.z},
        c(-Wide(sphere.radius) * sphere.radius) {
    const std::array<Wide, 3> C{sphere.centre.x, sphere.centre.y, sphere.centre.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide T = C[k] - L[k];
      a += d[k] * d[k];
      b += T * d[k];
      c += T * T;
    }
    discriminant = b * b - a * c;
  }
  /// By the quotient that does not cancel, of exact signs.
  Wide root(int which) const {
    const Wide root = sqrt(discriminant);
    if (c == 0) return (b > 0) == (which > 0) && b != 0 ? Wide(2 * b / a) : Wide(0);
    return (b > 0) == (which > 0) ? Wide((b + which * root) / a) : Wide(c / (b - which * root));
  }
  Wide point(int which, std::size_t k) const { return L[k] + root(which) * d[k]; }
  /// -1 or 1: which root counts; 0: a miss.
  int chosen(scene::Root convention) const {
    if (discriminant < 0) return 0;
    if (root(-1) >= 0) return -1;
    return convention == scene::Root::kNearest && root(1) >= 0 ? 1 : 0;
  }
};

/// Where coordinates cancel exactly, what is left of 6600 bits is 0.
Wide cleaned(const Wide& x, const Wide& of) {
  return abs(x) < abs(of) * Wide(ldexp(Wide(1), -5000)) ? Wide(0) : x;
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
  for (std::size_t k = 0; k < 3; ++k) {
    truth.Q[k] = nearest_float(cleaned(pair.point(which, k), pair.L[k]));
  }
  return truth;
}

FloatErrors float_errors(const scene::Ray& ray, const scene::Sphere& sphere, scene::Root root,
                         double s, const scene::Point3& Q) {
  const Pair pair(ray, sphere);
  const int which = pair.chosen(root);
  FloatErrors errors;
  const Wide exact = pair.root(which);
  if (pair.discriminant != 0) {
    const Wide other = pair.root(-which);
    errors.is_at_other_root = 4 * abs(Wide(s) - other) < abs(Wide(other - exact));
  }
  errors.s = in_gaps(abs(Wide(s) - exact), exact);
  const double given[] = {Q.x, Q.y, Q.z};
  Wide size_sq = 0, off_sq = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide at = cleaned(pair.point(which, k), pair.L[k]), apart = Wide(given[k]) - at;
    size_sq += at * at;
    off_sq += apart * apart;
  }
  if (size_sq == 0) {
    errors.Q = off_sq == 0 ? 0 : kInfinity;
  } else {
    errors.Q = std::ldexp(Wide(sqrt(Wide(off_sq / size_sq))).convert_to<double>(), kFloatDigits);
  }
  return errors;
}

}  // namespace raycheck::tests
