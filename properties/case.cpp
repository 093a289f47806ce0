#include "properties/case.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "scene/fields.h"
#include "scene/number.h"
#include "scene/validate.h"

namespace raycheck::properties {

std::size_t count_rays(const Case& the_case) {
  return the_case.scene.camera ? the_case.pixels.size() : the_case.scene.rays.size();
}

std::vector<scene::Pixel> all_pixels(const scene::Camera& camera) {
  std::vector<scene::Pixel> pixels;
  pixels.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (std::int64_t j = 0; j < camera.height; ++j) {
    for (std::int64_t i = 0; i < camera.width; ++i) pixels.push_back({i, j});
  }
  return pixels;
}

using scene::Precision;

namespace {

/// Rounding the coordinates of a unit vector changes its length by at most u, and the square of its
/// length by about 2 u.
bool is_unit(const scene::Vector3& v, Precision precision) {
  const auto square = [](double x) { return static_cast<long double>(x) * x; };
  const long double off = square(v.x) + square(v.y) + square(v.z) - 1;
  return std::abs(off) <= 4 * scene::unit_roundoff(precision);
}

/// Without overflow. Computes in long double; the caller rounds the coordinates to the format.
void make_unit(scene::Vector3& v) {
  const long double x = v.x, y = v.y, z = v.z;
  const long double length = std::hypot(x, y, z);
  v = {static_cast<double>(x / length), static_cast<double>(y / length),
       static_cast<double>(z / length)};
}

/// Moves the origin and the end of a segment to multiples of two units in the last place of the
/// larger of them, so that their difference, the direction, is exact.
void make_segment(double& origin, double& step, Precision precision) {
  const auto unit_of = [&](double x) {
    return x == 0 ? 0 : std::scalbn(scene::unit_roundoff(precision), std::ilogb(x) + 2);
  };
  const double end = origin + step;
  const double unit = std::max(unit_of(origin), unit_of(end));
  if (end - origin == step && end - step == origin && scene::rounded_to(precision, end) == end) {
    return;
  }
  const auto to_unit = [&](double x) { return std::nearbyint(x / unit) * unit; };
  origin = to_unit(origin);
  step = to_unit(end) - origin;
}
void make_segment(scene::Ray& ray, Precision precision) {
  auto& [origin, step] = ray;
  make_segment(origin.x, step.x, precision);
  make_segment(origin.y, step.y, precision);
  make_segment(origin.z, step.z, precision);
}

}  // namespace

scene::Ray with_unit_direction(scene::Ray ray, Precision precision) {
  auto& [x, y, z] = ray.direction;
  if (is_unit(ray.direction, precision)) return ray;
  make_unit(ray.direction);
  for (double* one : {&x, &y, &z}) *one = scene::rounded_to(precision, *one);
  return ray;
}

RoundedCase rounded_case(Case the_case, InputFormat format) {
  const Precision precision = format.precision;
  RoundedCase result;
  scene::Samples& samples = the_case.scene.conventions.samples;
  if (!format.corners && samples == scene::Samples::kCorners) samples = scene::Samples::kCentres;
  if (format.unit_directions) {
    for (scene::Ray& ray : the_case.scene.rays) {
      if (is_unit(ray.direction, precision)) continue;
      make_unit(ray.direction);
      ++result.made_unit;
    }
  }
  if (format.segments) {
    for (scene::Ray& ray : the_case.scene.rays) {
      ray = rounded_ray(ray, format);
      if (!scene::defects(ray).empty()) {
        result.reason = "a segment's end rounds to its origin, or out of range";
        return result;
      }
    }
  }
  if (precision == Precision::kDouble) {
    result.the_case = std::move(the_case);
    return result;
  }
  const auto round = [&](double& x) {
    const double rounded = scene::rounded_to(precision, x);
    if (rounded == x) return;
    ++result.changed;
    const bool is_lost = !std::isfinite(rounded) || rounded == 0;
    if (is_lost && result.reason.empty()) {
      result.reason =
          "rounded to floats: " + scene::shortest(x) + " is outside the range of floats";
    }
    x = rounded;
  };
  for_each_number(the_case.scene, round);
  scene::ValidRoots& valid = the_case.scene.conventions.valid;
  round(valid.t_min);
  round(valid.t_max);
  if (the_case.scene.camera) the_case.scene.camera->far.reset();
  if (!result.reason.empty()) return result;
  const auto defects = scene::defects(the_case.scene);
  if (!defects.empty()) {
    result.reason = "rounded to floats: " + defects.front().field + " = " + defects.front().value +
                    ": " + defects.front().what;
    return result;
  }
  result.the_case = std::move(the_case);
  return result;
}

scene::Ray rounded_ray(scene::Ray ray, InputFormat format) {
  const Precision precision = format.precision;
  if (format.unit_directions && !is_unit(ray.direction, precision)) make_unit(ray.direction);
  for (double* x : {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x, &ray.direction.y,
                    &ray.direction.z}) {
    *x = scene::rounded_to(precision, *x);
  }
  if (format.segments) make_segment(ray, precision);
  return ray;
}

bool is_of_format(const scene::Scene& scene, InputFormat format) {
  const Precision precision = format.precision;
  bool all = !format.unit_directions ||
             std::all_of(scene.rays.begin(), scene.rays.end(),
                         [&](const scene::Ray& ray) { return is_unit(ray.direction, precision); });
  if (format.segments) {
    all = all && std::ranges::all_of(scene.rays, [&](const scene::Ray& ray) {
            return rounded_ray(ray, format) == ray;
          });
  }
  if (precision == Precision::kDouble) return all;
  scene::Scene copy = scene;
  const auto look = [&](const double& x) { all = all && scene::rounded_to(precision, x) == x; };
  for_each_number(copy, look);
  look(scene.conventions.valid.t_min);
  look(scene.conventions.valid.t_max);
  return all;
}

}  // namespace raycheck::properties
