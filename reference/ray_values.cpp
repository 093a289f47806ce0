// Narrow enclosures and correctly rounded values of a ray: double-doubles first, balls where these
// are too wide, the exact field for zeros and ties.

#include <optional>
#include <utility>

#include "reference/internal/ray_impl.h"

namespace raycheck::reference {
namespace {

ExactNumber exact(const Rational& value) { return ExactNumber(FirstExtension(value)); }

/// value(lift, line) by double-doubles. A separate function, so that no operation moves to where
/// doubles round upward.
template <class Value>
[[gnu::noinline]] auto by_double_doubles(const ExactRay& ray, const Value& value) {
  const NearestGuard guard;
  return value(DoubleDoubleLift{}, line_in_double_doubles(ray));
}

template <class Value>
auto by_balls(const ExactRay& ray, const Value& value, int bits) {
  const EnclosureLift lift{bits};
  return value(lift, line_of(lift, ray.source()));
}

/// Applies narrow() or round_to_nearest() to value(lift, line), a number; compare(m) is the exact
/// sign of value - m.
template <class Value, class Compare, class Finish>
auto finish_number(const ExactRay& ray, const Value& value, Compare compare, Finish finish) {
  const DoubleDouble first = by_double_doubles(ray, value);
  return finish(
      first.is_within(finish.relative_bits) ? first.enclosure() : by_balls(ray, value, kFirstBits),
      [&](int bits) { return by_balls(ray, value, bits); }, compare);
}

/// The same for a vector's three coordinates; compare(k, m) is the exact sign of coordinate k - m.
template <class Result, class Value, class Compare, class Finish>
Result finish_vector(const ExactRay& ray, const Value& value, Compare compare, Finish finish) {
  const DoubleDoubleKernel::Vector_3 first = by_double_doubles(ray, value);
  std::optional<EnclosureKernel::Vector_3> balls;
  const auto coordinate = [&](int k) {
    const bool is_narrow = first[k].is_within(finish.relative_bits);
    if (!is_narrow && !balls) balls = by_balls(ray, value, kFirstBits);
    return finish(
        is_narrow ? first[k].enclosure() : (*balls)[k],
        [&, k](int bits) { return by_balls(ray, value, bits)[k]; },
        [&, k](const Rational& m) { return compare(k, m); });
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// narrow() to a relative width.
struct Narrow {
  int relative_bits;
  template <class Enclose, class Compare>
  Enclosure operator()(Enclosure first, Enclose enclose, Compare compare) const {
    return narrow(std::move(first), relative_bits, enclose, compare);
  }
};

/// round_to_nearest(), starting from an enclosure that leaves few values undecided.
struct Round {
  static constexpr int relative_bits = ExactRay::kValueBits;
  template <class Enclose, class Compare>
  double operator()(Enclosure first, Enclose enclose, Compare compare) const {
    return round_to_nearest(std::move(first), enclose, compare);
  }
};
struct RoundToSingle {
  static constexpr int relative_bits = ExactRay::kValueBits;
  template <class Enclose, class Compare>
  double operator()(Enclosure first, Enclose enclose, Compare compare) const {
    return round_to_single(round_to_nearest(std::move(first), enclose, compare), compare);
  }
};

/// finish(Round{}), or the one that rounds to floats.
template <class Finish>
auto rounded(scene::Precision precision, const Finish& finish) {
  return precision == scene::Precision::kDouble ? finish(Round{}) : finish(RoundToSingle{});
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

template <class Finish>
auto finish_parameter(const ExactRay& ray, const scene::Sphere& sphere, const Intersection& at,
                      Finish finish) {
  scene::require_valid(sphere);
  ExactValues values(ray);
  return finish_number(
      ray,
      [&]<class K>(const auto& lift, const Line<K>& line) {
        return ray_parameter(line_and_sphere(line, lift_sphere<K>(lift, sphere)), root_sign(at));
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
      [&]<class K>(const auto& lift, const Line<K>& line) {
        return hit_point(line_and_sphere(line, lift_sphere<K>(lift, sphere)), root_sign(at));
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
  return rounded(precision,
                 [&](auto round) { return finish_pixel_point<scene::Point3>(*this, round); });
}
scene::Point3 ExactRay::rounded_origin(scene::Precision precision) const {
  return rounded(precision, [&](auto round) { return finish_origin<scene::Point3>(*this, round); });
}
scene::UnitVector3 ExactRay::rounded_direction(scene::Precision precision) const {
  return rounded(precision,
                 [&](auto round) { return finish_direction<scene::UnitVector3>(*this, round); });
}
double ExactRay::rounded_parameter(const scene::Sphere& sphere, const Intersection& intersection,
                                   scene::Precision precision) const {
  return rounded(precision,
                 [&](auto round) { return finish_parameter(*this, sphere, intersection, round); });
}
scene::Point3 ExactRay::rounded_point(const scene::Sphere& sphere, const Intersection& intersection,
                                      scene::Precision precision) const {
  return rounded(precision, [&](auto round) {
    return finish_point<scene::Point3>(*this, sphere, intersection, round);
  });
}

}  // namespace raycheck::reference
