// Narrow enclosures and correctly rounded values of a ray: balls first, the exact field for zeros
// and ties.

#include <optional>
#include <utility>

#include "reference/ray_impl.h"

namespace raycheck::reference {
namespace {

ExactNumber exact(const Rational& value) { return ExactNumber(FirstExtension(value)); }

/// Applies narrow() or round_to_nearest() to the three coordinates of an EnclosedRay's value;
/// compare(k, m) is the exact sign of coordinate k - m.
template <class Result, class Value, class Compare, class Finish>
Result finish_vector(const ExactRay& ray, Value value, Compare compare, Finish finish) {
  Enclosure3 first = value(ray.enclose(kFirstBits));
  const auto coordinate = [&](int k, Enclosure Enclosure3::*member) {
    return finish(
        std::move(first.*member),
        [&, member](int bits) { return value(ray.enclose(bits)).*member; },
        [&, k](const Rational& m) { return compare(k, m); });
  };
  return {coordinate(0, &Enclosure3::x), coordinate(1, &Enclosure3::y),
          coordinate(2, &Enclosure3::z)};
}

auto narrow_to(int relative_bits) {
  return [relative_bits](Enclosure first, auto enclose, auto compare) {
    return narrow(std::move(first), relative_bits, enclose, compare);
  };
}

auto rounded() {
  return [](Enclosure first, auto enclose, auto compare) {
    return round_to_nearest(std::move(first), enclose, compare);
  };
}

/// Exact comparisons of a line's values with rationals; the line is made on first use.
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
    const auto pair = line_and_sphere(line(), lift_sphere<ExactKernel>(ExactLift{}, sphere));
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
    const auto pair = line_and_sphere(line(), lift_sphere<ExactKernel>(ExactLift{}, sphere));
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
Result finish_pixel_point(const ExactRay& ray, ExactValues values, Finish finish) {
  return finish_vector<Result>(
      ray, [](const EnclosedRay& at) { return at.pixel_point(); },
      [&](int k, const Rational& m) { return values.compare_pixel_point(k, m); }, finish);
}

template <class Result, class Finish>
Result finish_origin(const ExactRay& ray, ExactValues values, Finish finish) {
  return finish_vector<Result>(
      ray, [](const EnclosedRay& at) { return at.origin(); },
      [&](int k, const Rational& m) { return values.compare_origin(k, m); }, finish);
}

template <class Result, class Finish>
Result finish_direction(const ExactRay& ray, ExactValues values, Finish finish) {
  return finish_vector<Result>(
      ray, [](const EnclosedRay& at) { return at.direction(); },
      [&](int k, const Rational& m) { return values.compare_direction(k, m); }, finish);
}

template <class Result, class Finish>
Result finish_point(const ExactRay& ray, ExactValues values, const scene::Sphere& sphere,
                    const Intersection& at, Finish finish) {
  return finish_vector<Result>(
      ray, [&](const EnclosedRay& enclosed) { return enclosed.point(sphere, at); },
      [&](int k, const Rational& m) { return values.compare_point(sphere, at, k, m); }, finish);
}

template <class Finish>
auto finish_parameter(const ExactRay& ray, ExactValues values, const scene::Sphere& sphere,
                      const Intersection& at, Finish finish) {
  return finish(
      ray.enclose(kFirstBits).parameter(sphere, at),
      [&](int bits) { return ray.enclose(bits).parameter(sphere, at); },
      [&](const Rational& m) { return values.compare_parameter(sphere, at, m); });
}

}  // namespace

Enclosure3 ExactRay::pixel_point(int relative_bits) const {
  return finish_pixel_point<Enclosure3>(*this, ExactValues(*this), narrow_to(relative_bits));
}
Enclosure3 ExactRay::origin(int relative_bits) const {
  return finish_origin<Enclosure3>(*this, ExactValues(*this), narrow_to(relative_bits));
}
Enclosure3 ExactRay::direction(int relative_bits) const {
  return finish_direction<Enclosure3>(*this, ExactValues(*this), narrow_to(relative_bits));
}
Enclosure ExactRay::parameter(const scene::Sphere& sphere, const Intersection& intersection,
                              int relative_bits) const {
  return finish_parameter(*this, ExactValues(*this), sphere, intersection,
                          narrow_to(relative_bits));
}
Enclosure3 ExactRay::point(const scene::Sphere& sphere, const Intersection& intersection,
                           int relative_bits) const {
  return finish_point<Enclosure3>(*this, ExactValues(*this), sphere, intersection,
                                  narrow_to(relative_bits));
}

scene::Point3 ExactRay::rounded_pixel_point() const {
  return finish_pixel_point<scene::Point3>(*this, ExactValues(*this), rounded());
}
scene::Point3 ExactRay::rounded_origin() const {
  return finish_origin<scene::Point3>(*this, ExactValues(*this), rounded());
}
scene::UnitVector3 ExactRay::rounded_direction() const {
  return finish_direction<scene::UnitVector3>(*this, ExactValues(*this), rounded());
}
double ExactRay::rounded_parameter(const scene::Sphere& sphere,
                                   const Intersection& intersection) const {
  return finish_parameter(*this, ExactValues(*this), sphere, intersection, rounded());
}
scene::Point3 ExactRay::rounded_point(const scene::Sphere& sphere,
                                      const Intersection& intersection) const {
  return finish_point<scene::Point3>(*this, ExactValues(*this), sphere, intersection, rounded());
}

}  // namespace raycheck::reference
