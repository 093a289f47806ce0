#include "reference/ray_error.h"

#include <algorithm>
#include <cmath>

#include "reference/error_measure.h"
#include "reference/internal/error_formulas.h"
#include "reference/internal/ray_impl.h"

namespace raycheck::reference {
namespace {

using scene::Measured;

constexpr int kBits = 256;

Triple<DoubleDouble> triple(const DoubleDoubleKernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

/// Calls measure(line) with the line in double-doubles.
template <class Measure>
auto error_by_double_doubles(const ExactRay& ray, const Measure& measure) {
  return reference::by_double_doubles([&] { return measure(line_in_double_doubles(ray)); });
}

template <class Measure>
auto error_by_double_doubles(const ExactRay& ray, const scene::Sphere& sphere,
                             const Measure& measure) {
  scene::require_valid(sphere);
  return error_by_double_doubles(ray, [&](const Line<DoubleDoubleKernel>& line) {
    return measure(line_and_sphere(line, lift_sphere(DoubleDoubleLift{}, sphere)));
  });
}

using Pair = LineAndSphere<DoubleDoubleKernel>;

/// The distance of a point from value(line), relative to that.
template <class Value>
std::optional<Measured> distance_by_double_doubles(const ExactRay& ray, const scene::Point3& given,
                                                   const Value& value) {
  return error_by_double_doubles(ray, [&](const Line<DoubleDoubleKernel>& line) {
    return narrow_error_in_u(relative_distance(in_double_doubles(given), triple(value(line))));
  });
}

/// The exponent of a format's ulp at the smallest number in the interval, which is the smallest ulp
/// in it; empty if unknown.
std::optional<int> ulp_exponent(const DoubleDouble& x, scene::Precision precision) {
  const double lower = abs(x).lower();
  if (!(lower >= std::numeric_limits<double>::min()) || !std::isfinite(x.high())) return {};
  const scene::Format format = scene::format_of(precision);
  return std::max(std::ilogb(lower) - (format.digits - 1), format.least_exponent);
}

}  // namespace

Measured pixel_point_error(const ExactRay& ray, const scene::Point3& given) {
  const auto error =
      distance_by_double_doubles(ray, given, [](const auto& line) { return line.base + line.g; });
  return error ? *error : relative_error(given, ray.pixel_point());
}

Measured origin_error(const ExactRay& ray, const scene::Point3& given) {
  const auto error =
      distance_by_double_doubles(ray, given, [](const auto& line) { return ray_origin(line); });
  return error ? *error : relative_error(given, ray.origin());
}

Measured direction_error(const ExactRay& ray, const scene::UnitVector3& given) {
  const auto error = error_by_double_doubles(ray, [&](const auto& line) -> std::optional<Measured> {
    const Triple<DoubleDouble> direction = in_double_doubles(given);
    const Triple<DoubleDouble> exact = triple(unit_direction(line));
    const DoubleDouble cosine = dot(direction, exact);
    if (cosine.certain_sign() != 1) return std::nullopt;
    return narrow_error_in_u(tangent(direction, exact, cosine));
  });
  return error ? *error : angle_error(given, ray.direction());
}

Measured parameter_error(const ExactRay& ray, const scene::Sphere& sphere,
                         const Intersection& intersection, double given,
                         scene::Precision precision) {
  const auto error =
      error_by_double_doubles(ray, sphere, [&](const Pair& pair) -> std::optional<double> {
        const DoubleDouble exact = ray_parameter(pair, root_sign(intersection));
        const std::optional<int> exponent = ulp_exponent(exact, precision);
        return exponent ? narrow_error(abs(DoubleDouble(given) - exact), *exponent) : std::nullopt;
      });
  return error ? Measured{*error, scene::Unit::kUlp, precision}
               : ulp_error(given, ray.parameter(sphere, intersection), precision);
}

Measured hit_point_error(const ExactRay& ray, const scene::Sphere& sphere,
                         const Intersection& intersection, const scene::Point3& given) {
  const auto error = error_by_double_doubles(ray, sphere, [&](const Pair& pair) {
    return narrow_error_in_u(relative_distance(in_double_doubles(given),
                                               triple(hit_point(pair, root_sign(intersection)))));
  });
  return error ? *error : relative_error(given, ray.point(sphere, intersection));
}

HitInDoubleDoubles hit_in_double_doubles(const ExactRay& ray, const scene::Sphere& sphere,
                                         const Intersection& intersection) {
  return error_by_double_doubles(ray, sphere, [&](const Pair& pair) -> HitInDoubleDoubles {
    const int sign = root_sign(intersection);
    return {ray_length(pair.line), ray_parameter(pair, sign), triple(ray_origin(pair.line)),
            triple(hit_point(pair, sign))};
  });
}

std::optional<Measured> sphere_residual(const scene::Sphere& sphere, const scene::Point3& given) {
  if (sphere.radius == 0) return std::nullopt;
  const std::optional<Measured> error = by_double_doubles([&] {
    return narrow_error_in_u(distance_from_sphere(
        in_double_doubles(given), in_double_doubles(sphere.centre), DoubleDouble(sphere.radius)));
  });
  if (error) return error;
  return in_units_of_u(distance_from_sphere(enclose_exactly(given), enclose_exactly(sphere.centre),
                                            Enclosure(sphere.radius, kBits)));
}

std::optional<Measured> ray_residual(const ExactRay& ray, const scene::Point3& given) {
  const auto error = error_by_double_doubles(ray, [&](const auto& line) {
    const Triple<DoubleDouble> along = in_double_doubles(given) - triple(ray_origin(line));
    return narrow_error_in_u(distance_from_line(along, triple(unit_direction(line))));
  });
  if (error) return error;
  const EnclosedRay enclosed = ray.enclose(kBits);
  const Enclosure3 along = enclose_exactly(given) - enclosed.origin();
  if (norm(along).contains_zero()) return std::nullopt;
  return in_units_of_u(distance_from_line(along, enclosed.direction()));
}

namespace {

/// Calls value(pair) with intervals. A separate function, so that the compiler moves no operation
/// to where doubles round to nearest.
template <class Value>
[[gnu::noinline]] auto by_intervals(const ExactRay& ray, const scene::Sphere& sphere,
                                    const Value& value) {
  const IntervalGuard guard;
  const auto line = line_of(IntervalLift{}, ray.source());
  return value(line_and_sphere(line, lift_sphere(IntervalLift{}, sphere)));
}

}  // namespace

bool is_at_other_root(const ExactRay& ray, const scene::Sphere& sphere,
                      const Intersection& intersection, double given) {
  if (intersection.hit_class == HitClass::kTangent || !std::isfinite(given)) return false;
  Intersection other = intersection;
  other.root = intersection.root == WhichRoot::kSmaller ? WhichRoot::kLarger : WhichRoot::kSmaller;
  const auto margin = [&](const auto& root, const auto& other_root, const auto& answer) {
    using Number = std::decay_t<decltype(root)>;
    return abs(other_root - root) - Number(kOtherRootShare) * abs(answer - other_root);
  };
  const auto sign_of_margin = [&]<class K>(const LineAndSphere<K>& pair) {
    return certain_sign(margin(ray_parameter(pair, root_sign(intersection)),
                               ray_parameter(pair, root_sign(other)), typename K::FT(given)));
  };
  scene::require_valid(sphere);
  if (const auto sign = by_intervals(ray, sphere, sign_of_margin)) return *sign == 1;
  if (const auto sign = error_by_double_doubles(ray, sphere, sign_of_margin)) return *sign == 1;
  const EnclosedRay enclosed = ray.enclose(kBits);
  return certain_sign(margin(enclosed.parameter(sphere, intersection),
                             enclosed.parameter(sphere, other), Enclosure(given, kBits))) == 1;
}

}  // namespace raycheck::reference
