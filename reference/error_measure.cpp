#include "reference/error_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/internal/error_formulas.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

using scene::Measured;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
static_assert(2 * kErrorWidth <= kUnitDefectWidth);

template <class Triple>
bool is_finite(const Triple& value) {
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

template <class Triple>
Measured relative_error_of(const Triple& given, const Enclosure3& exact) {
  if (!is_finite(given)) return {kInfinity};
  const Enclosure3 answer = enclose_exactly(given);
  const Enclosure3 off = answer - exact;
  const auto is_zero = [](const Enclosure& x) { return x.certain_sign() == 0; };
  if (is_zero(off.x) && is_zero(off.y) && is_zero(off.z)) return {0};
  return norm(exact).contains_zero() ? Measured{kInfinity}
                                     : in_units_of_u(relative_distance(answer, exact));
}

}  // namespace

Measured ulp_error(double given, const Enclosure& exact, scene::Precision precision) {
  const auto ulp = [precision](double value) {
    return Measured{value, scene::Unit::kUlp, precision};
  };
  if (!std::isfinite(given)) return ulp(kInfinity);
  if (exact.certain_sign() == 0) return ulp(given == 0 ? 0 : kInfinity);
  // 128 bits are two words; more would need heap memory.
  Enclosure error(given, 128);
  arb_sub(error.ball(), error.ball(), exact.ball(), 128);
  arb_abs(error.ball(), error.ball());
  arf_t magnitude;
  arf_init(magnitude);
  arb_get_abs_lbound_arf(magnitude, exact.ball(), 64);
  const scene::Format format = scene::format_of(precision);
  // 2^(exponent-1) <= |exact| < 2^exponent, so that the gap is 2^(exponent-digits).
  const slong exponent =
      arf_is_zero(magnitude) ? format.least_exponent : arf_abs_bound_lt_2exp_si(magnitude);
  arf_clear(magnitude);
  const slong ulp_exponent = std::max<slong>(exponent - format.digits, format.least_exponent);
  arb_mul_2exp_si(error.ball(), error.ball(), -ulp_exponent);
  return ulp(error.upper());
}

Measured ulp_error(double given, double exact, scene::Precision precision) {
  const double size = std::abs(exact);
  // Then the difference is exact.
  const bool is_near = std::isfinite(given) && exact * given > 0 && size <= 2 * std::abs(given) &&
                       std::abs(given) <= 2 * size;
  if (!is_near) return ulp_error(given, Enclosure(exact, 128), precision);
  const scene::Format format = scene::format_of(precision);
  const int exponent = std::max(std::ilogb(size) - (format.digits - 1), format.least_exponent);
  return {std::ldexp(std::abs(given - exact), -exponent), scene::Unit::kUlp, precision};
}

Measured relative_error(const scene::Point3& given, const Enclosure3& exact) {
  return relative_error_of(given, exact);
}
Measured relative_error(const scene::UnitVector3& given, const Enclosure3& exact) {
  return relative_error_of(given, exact);
}

Measured relative_error(const scene::UnitVector3& given, const scene::UnitVector3& exact) {
  if (given == exact && is_finite(given)) return {0};
  return relative_error(given, enclose_exactly(exact));
}

Measured angle_error(const scene::UnitVector3& given, const Enclosure3& exact) {
  if (!is_finite(given)) return {kInfinity};
  const Enclosure3 direction = enclose_exactly(given);
  const Enclosure cosine = dot(direction, exact);
  if (cosine.certain_sign() != 1) return {kInfinity};
  return in_units_of_u(tangent(direction, exact, cosine));
}

Measured unit_defect(const scene::UnitVector3& given) {
  if (!is_finite(given)) return {kInfinity};
  const std::optional<Measured> defect = by_double_doubles(
      [&] { return narrow_error_in_u(distance_from_unit(in_double_doubles(given))); });
  if (defect) return *defect;
  return in_units_of_u(distance_from_unit(enclose_exactly(given)));
}

Measured backward_error(const scene::Ray& ray, const scene::Sphere& sphere, double parameter) {
  scene::require_valid(ray);
  scene::require_valid(sphere);
  if (!std::isfinite(parameter)) return {kInfinity};
  // Doubles span 2098 bits, q at most 4200 and p at most 8500. With 8500 bits the balls are
  // exact, and the loop ends.
  for (int bits = 384;; bits *= 2) {
    const Enclosure s(parameter, bits);
    const Enclosure r_sq = Enclosure(sphere.radius, bits) * Enclosure(sphere.radius, bits);
    Enclosure p = -r_sq;
    Enclosure half_change = r_sq;
    const auto add_coordinate = [&](double origin, double direction, double centre) {
      const Enclosure L(origin, bits);
      const Enclosure C(centre, bits);
      const Enclosure step = s * Enclosure(direction, bits);
      const Enclosure q = L + step - C;
      p += q * q;
      half_change += abs(q) * (abs(L) + abs(C) + abs(step));
    };
    add_coordinate(ray.origin.x, ray.direction.x, sphere.centre.x);
    add_coordinate(ray.origin.y, ray.direction.y, sphere.centre.y);
    add_coordinate(ray.origin.z, ray.direction.z, sphere.centre.z);
    if (p.certain_sign() == 0) return {0};
    Enclosure error = abs(p) / half_change;
    if (!error.is_within(1 - std::ilogb(kBackwardErrorWidth))) continue;
    arb_mul_2exp_si(error.ball(), error.ball(), std::numeric_limits<double>::digits - 1);
    return {std::min(error.upper(), kMostBackwardError)};
  }
}

Measured in_units_of_u(const Enclosure& x) {
  Enclosure scaled = abs(x);
  arb_mul_2exp_si(scaled.ball(), scaled.ball(), std::numeric_limits<double>::digits);
  const double bound = scaled.upper();
  // If the ball's upper bound is infinite or NaN, the error has no bound.
  return {bound < std::numeric_limits<double>::max() ? bound : kInfinity};
}

}  // namespace raycheck::reference
