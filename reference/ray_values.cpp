// Narrow enclosures and correctly rounded values of a ray: by double-doubles; by balls if these are
// too wide; by the exact field for zeros and ties.

#include <optional>
#include <type_traits>
#include <utility>

#include "reference/internal/ray_impl.h"

namespace raycheck::reference {
namespace {

ExactNumber exact(const Rational& value) { return ExactNumber(FirstExtension(value)); }

/// Calls value(lift, line) with double-doubles.
template <class Value>
auto by_double_doubles(const ExactRay& ray, const Value& value) {
  return reference::by_double_doubles(
      [&] { return value(DoubleDoubleLift{}, line_in_double_doubles(ray)); });
}

template <class Value>
auto by_balls(const ExactRay& ray, const Value& value, int bits) {
  const EnclosureLift lift{bits};
  return value(lift, line_of(lift, ray.source()));
}

/// The double nearest to a number; empty if double-doubles cannot decide.
std::optional<double> nearest_of(const DoubleDouble& value) {
  return reference::by_double_doubles([&] { return value.nearest(); });
}
template <class Finish>
constexpr bool kRounds = std::is_same_v<Finish, Round>;

/// Applies narrow() or round_to_nearest() to the number value(lift, line); compare(m) is the exact
/// sign of value - m. If double-doubles cannot exclude that the value is 0, is_zero(lift, line) may
/// show that it is.
template <class Value, class IsZero, class Compare, class Finish>
auto finish_number(const ExactRay& ray, const Value& value, IsZero is_zero, Compare compare,
                   Finish finish) {
  const DoubleDouble first = by_double_doubles(ray, value);
  if constexpr (kRounds<Finish>) {
    if (const auto nearest = nearest_of(first)) return finish(*nearest, compare);
  }
  using Result = std::conditional_t<kRounds<Finish>, double, Enclosure>;
  if (!first.certain_sign() && by_double_doubles(ray, is_zero)) return Result(0);
  return finish(
      first.is_within(finish.relative_bits) ? first.enclosure() : by_balls(ray, value, kFirstBits),
      [&](int bits) { return by_balls(ray, value, bits); }, compare);
}

/// Does the same for a vector's three coordinates; compare(k, m) is the exact sign of coordinate k
/// minus m.
template <class Result, class Value, class Compare, class Finish>
Result finish_vector(const ExactRay& ray, const Value& value, Compare compare, Finish finish) {
  const DoubleDoubleKernel::Vector_3 first = by_double_doubles(ray, value);
  std::optional<EnclosureKernel::Vector_3> balls;
  const auto coordinate = [&](int k) {
    const auto compare_this = [&, k](const Rational& m) { return compare(k, m); };
    if constexpr (kRounds<Finish>) {
      if (const auto nearest = nearest_of(first[k])) return finish(*nearest, compare_this);
    }
    const bool is_narrow = first[k].is_within(finish.relative_bits);
    if (!is_narrow && !balls) balls = by_balls(ray, value, kFirstBits);
    return finish(
        is_narrow ? first[k].enclosure() : (*balls)[k],
        [&, k](int bits) { return by_balls(ray, value, bits)[k]; }, compare_this);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// Compares a line's values with rationals, exactly. The line is made on first use.
class ExactValues {
 public:
  explicit ExactValues(const ExactRay& ray) : source_(ray.source()) {}

  int compare_pixel_point(int k, const Rational& m) {
    return *certain_sign(line().base[k] + line().g[k] - exact(m));
  }
  int compare_origin(int k, const Rational& m) {
    return *certain_sign(ray_origin(line())[k] - exact(m));
  }
  /// g_k / sqrt(a) - m
  int compare_direction(int k, const Rational& m) {
    return *sign_of_radical_sum(line().g[k], exact(-m), line().a, ExactNumber(0), ExactNumber(0));
  }
  /// (b +- sqrt(disc)) / sqrt(a) - m for a camera's ray, (b +- sqrt(disc)) / a - m for a given one.
  int compare_parameter(const scene::Sphere& sphere, const Intersection& at, const Rational& m) {
    const auto pair = line_and_sphere(line(), lift_sphere(ExactLift{}, sphere));
    const ExactNumber b = linear_coefficient(pair);
    const ExactNumber sign(root_sign(at));
    if (line().is_unit) {
      return *sign_of_radical_sum(b, exact(-m), line().a, sign, discriminant(pair));
    }
    return *sign_of_radical_sum(b - exact(m) * line().a, sign, discriminant(pair), ExactNumber(0),
                                ExactNumber(0));
  }
  /// L_k + (b +- sqrt(disc)) g_k / a - m
  int compare_point(const scene::Sphere& sphere, const Intersection& at, int k, const Rational& m) {
    const auto pair = line_and_sphere(line(), lift_sphere(ExactLift{}, sphere));
    const ExactNumber& g = line().g[k];
    return *sign_of_radical_sum(
        (ray_origin(line())[k] - exact(m)) * line().a + linear_coefficient(pair) * g,
        ExactNumber(root_sign(at)) * g, discriminant(pair), ExactNumber(0), ExactNumber(0));
  }

 private:
  const Line<ExactKernel>& line() {
    if (!line_) line_ = line_of(ExactLift{}, source_);
    return *line_;
  }

  const ExactRay::Source& source_;
  std::optional<Line<ExactKernel>> line_;
};

template <class Result, class Finish>
Result finish_pixel_point(const ExactRay& ray, Finish finish) {
  ExactValues values(ray);
  return finish_vector<Result>(
      ray, [](const auto& /*lift*/, const auto& line) { return line.base + line.g; },
      [&](int k, const Rational& m) { return values.compare_pixel_point(k, m); }, finish);
}

template <class Result, class Finish>
Result finish_origin(const ExactRay& ray, Finish finish) {
  ExactValues values(ray);
  return finish_vector<Result>(
      ray, [](const auto& /*lift*/, const auto& line) { return ray_origin(line); },
      [&](int k, const Rational& m) { return values.compare_origin(k, m); }, finish);
}

template <class Result, class Finish>
Result finish_direction(const ExactRay& ray, Finish finish) {
  ExactValues values(ray);
  return finish_vector<Result>(
      ray, [](const auto& /*lift*/, const auto& line) { return unit_direction(line); },
      [&](int k, const Rational& m) { return values.compare_direction(k, m); }, finish);
}

/// Whether c is certainly 0, so that the roots are 0 and 2 b/a, and the given root is 0.
template <class K>
bool is_certainly_zero(const LineAndSphere<K>& pair, int root_sign) {
  if (certain_sign(constant_coefficient(pair)) != 0) return false;
  const std::optional<int> b = certain_sign(linear_coefficient(pair));
  return b && *b * root_sign <= 0;
}

template <class Finish>
auto finish_parameter(const ExactRay& ray, const scene::Sphere& sphere, const Intersection& at,
                      Finish finish) {
  scene::require_valid(sphere);
  ExactValues values(ray);
  return finish_number(
      ray,
      [&](const auto& lift, const auto& line) {
        return ray_parameter(line_and_sphere(line, lift_sphere(lift, sphere)), root_sign(at));
      },
      [&](const auto& lift, const auto& line) {
        return is_certainly_zero(line_and_sphere(line, lift_sphere(lift, sphere)), root_sign(at));
      },
      [&](const Rational& m) { return values.compare_parameter(sphere, at, m); }, finish);
}

template <class Result, class Finish>
Result finish_point(const ExactRay& ray, const scene::Sphere& sphere, const Intersection& at,
                    Finish finish) {
  scene::require_valid(sphere);
  ExactValues values(ray);
  return finish_vector<Result>(
      ray,
      [&](const auto& lift, const auto& line) {
        return hit_point(line_and_sphere(line, lift_sphere(lift, sphere)), root_sign(at));
      },
      [&](int k, const Rational& m) { return values.compare_point(sphere, at, k, m); }, finish);
}

}  // namespace

Enclosure3 ExactRay::pixel_point(int relative_bits) const {
  return finish_pixel_point<Enclosure3>(*this, Narrow{relative_bits});
}
Enclosure3 ExactRay::origin(int relative_bits) const {
  return finish_origin<Enclosure3>(*this, Narrow{relative_bits});
}
Enclosure3 ExactRay::direction(int relative_bits) const {
  return finish_direction<Enclosure3>(*this, Narrow{relative_bits});
}
Enclosure ExactRay::parameter(const scene::Sphere& sphere, const Intersection& intersection,
                              int relative_bits) const {
  return finish_parameter(*this, sphere, intersection, Narrow{relative_bits});
}
Enclosure3 ExactRay::point(const scene::Sphere& sphere, const Intersection& intersection,
                           int relative_bits) const {
  return finish_point<Enclosure3>(*this, sphere, intersection, Narrow{relative_bits});
}

scene::Point3 ExactRay::rounded_pixel_point(scene::Precision precision) const {
  return finish_pixel_point<scene::Point3>(*this, Round{precision});
}
scene::Point3 ExactRay::rounded_origin(scene::Precision precision) const {
  return finish_origin<scene::Point3>(*this, Round{precision});
}
scene::UnitVector3 ExactRay::rounded_direction(scene::Precision precision) const {
  return finish_direction<scene::UnitVector3>(*this, Round{precision});
}
double ExactRay::rounded_parameter(const scene::Sphere& sphere, const Intersection& intersection,
                                   scene::Precision precision) const {
  return finish_parameter(*this, sphere, intersection, Round{precision});
}
scene::Point3 ExactRay::rounded_point(const scene::Sphere& sphere, const Intersection& intersection,
                                      scene::Precision precision) const {
  return finish_point<scene::Point3>(*this, sphere, intersection, Round{precision});
}

// The values at one working precision.

Enclosure3 EnclosedRay::origin() const { return coordinates(ray_origin(impl_->line)); }
Enclosure3 EnclosedRay::pixel_point() const {
  return coordinates(impl_->line.base + impl_->line.g);
}
Enclosure3 EnclosedRay::direction() const { return coordinates(unit_direction(impl_->line)); }
Enclosure EnclosedRay::length() const { return ray_length(impl_->line); }
Enclosure EnclosedRay::parameter(const scene::Sphere& sphere,
                                 const Intersection& intersection) const {
  return ray_parameter(impl_->with(sphere), root_sign(intersection));
}
Enclosure3 EnclosedRay::point(const scene::Sphere& sphere, const Intersection& intersection) const {
  return coordinates(hit_point(impl_->with(sphere), root_sign(intersection)));
}
Enclosure EnclosedRay::half_chord_sq(const scene::Sphere& sphere) const {
  return reference::half_chord_sq(impl_->with(sphere));
}
Enclosure EnclosedRay::axial_distance(const scene::Sphere& sphere) const {
  return reference::axial_distance(impl_->with(sphere));
}

EnclosedRay ExactRay::enclose(int bits, double relative_change) const {
  const EnclosureLift lift{bits, relative_change};
  return EnclosedRay(
      std::make_shared<const EnclosedRay::Impl>(EnclosedRay::Impl{line_of(lift, source_), lift}));
}

}  // namespace raycheck::reference
