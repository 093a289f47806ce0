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

std::vector<Pixel> all_pixels(const Camera& camera) {
  std::vector<Pixel> pixels;
  pixels.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (std::int64_t j = 0; j < camera.height; ++j) {
    for (std::int64_t i = 0; i < camera.width; ++i) pixels.push_back({i, j});
  }
  return pixels;
}

namespace {

/// Rounding the coordinates of a unit vector changes its length by at most u, and the square of its
/// length by about 2 u.
bool is_unit(const Vector3& v, Precision precision) {
  const auto square = [](double x) { return static_cast<long double>(x) * x; };
  const long double off = square(v.x) + square(v.y) + square(v.z) - 1;
  return std::abs(off) <= 4 * scene::unit_roundoff(precision);
}

/// Without overflow. Computes in long double; the caller rounds the coordinates to the format.
void make_unit(Vector3& v) {
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
void make_segment(Ray& ray, Precision precision) {
  auto& [origin, step] = ray;
  make_segment(origin.x, step.x, precision);
  make_segment(origin.y, step.y, precision);
  make_segment(origin.z, step.z, precision);
}

/// The width of a pixel, rounded so that its product with half a count of pixels is exact.
double exact_pixel(double width, std::int64_t pixels, Precision precision) {
  const int digits = 1 - std::ilogb(scene::unit_roundoff(precision));
  const int left = std::max(1, digits - 1 - std::ilogb(static_cast<double>(pixels)) - 1);
  const int scale = left - 1 - std::ilogb(width);
  return std::scalbn(std::nearbyint(std::scalbn(width, scale)), -scale);
}

/// Moves and scales the scene so that its first sphere is one that the format accepts, and removes
/// the others. Returns whether it changed anything.
bool fit_spheres(Scene& scene, InputFormat format) {
  if (format.placement == contract::Placement::kAnywhere || scene.spheres.empty()) return false;
  const auto [centre, radius] = scene.spheres.front();
  const bool unit = format.placement == contract::Placement::kUnit;
  const Sphere placed = {{}, unit ? 1 : radius};
  if (scene.spheres == std::vector{placed}) return false;
  const double length = unit ? radius : 1;
  const auto along = [&](auto& triple, const auto& from) {
    triple = {(triple.x - from.x) / length, (triple.y - from.y) / length,
              (triple.z - from.z) / length};
  };
  scene.spheres = {placed};
  for (Ray& ray : scene.rays) {
    along(ray.origin, centre);
    along(ray.direction, Vector3{});
  }
  if (scene.camera) {
    Camera& camera = *scene.camera;
    along(camera.eye, centre);
    along(camera.look_at, centre);
    for (double* one : {&camera.near, &camera.left, &camera.right, &camera.bottom, &camera.top}) {
      *one /= length;
    }
  }
  return true;
}

/// What the candidate accepts.
std::string accepted(contract::Placement placement) {
  return placement == contract::Placement::kUnit
             ? "the unit sphere about the origin (placement unit)"
             : "one sphere, about the origin (placement origin)";
}
std::string accepted(contract::Windows windows) {
  return windows == contract::Windows::kSymmetric
             ? "symmetric windows: left = -right < 0, bottom = -top < 0, near < 0, a field of "
               "view of at most 166 degrees"
             : "symmetric windows with square pixels: left = -right < 0, bottom = -top < 0, "
               "right / top = width / height, near < 0, a field of view of at most 166 degrees";
}
const char* const kLooksAtCentre = "cameras that look at the centre of a sphere (view centre)";

/// The largest half of a window over near if it follows from a field of view, 166 degrees: tan(x)
/// then multiplies a rounding of the angle by at most 12.
constexpr double kWidest = 8;

/// Replaces a window that the format does not accept, and returns whether it did.
bool fit_window(Camera& camera, InputFormat format) {
  using contract::Windows;
  if (format.windows == Windows::kAny) return false;
  const Camera given = camera;
  double right = std::max(std::abs(camera.left), std::abs(camera.right));
  double top = std::max(std::abs(camera.bottom), std::abs(camera.top));
  const auto width = static_cast<double>(camera.width), height = static_cast<double>(camera.height);
  // A window that follows from an angle of view has square pixels up to roundings.
  const bool is_square = std::abs(right * height - top * width) <= 0x1p-50 * right * height;
  if (format.windows == Windows::kSquarePixels && !is_square) {
    const std::int64_t pixels = std::max(camera.width, camera.height);
    const double size = exact_pixel(top / height * 2, pixels, format.precision);
    right = size * width / 2;
    top = size * height / 2;
  }
  camera.near = -std::max({std::abs(camera.near), right / kWidest, top / kWidest});
  camera.left = -right;
  camera.right = right;
  camera.bottom = -top;
  camera.top = top;
  return camera != given;
}

/// Moves A to the centre of the first sphere, or E and A as the ends of a segment, if the format
/// needs that, and returns whether it did.
bool fit_view(Scene& scene, InputFormat format) {
  if (!scene.camera || format.view == contract::View::kLookAt) return false;
  Camera& camera = *scene.camera;
  if (format.view == contract::View::kCentre) {
    const Point3 centre = scene.spheres.empty() ? camera.look_at : scene.spheres.front().centre;
    return std::exchange(camera.look_at, centre) != centre;
  }
  const auto& [from, to] = std::pair(camera.eye, camera.look_at);
  Ray segment = {from, {to.x - from.x, to.y - from.y, to.z - from.z}};
  make_segment(segment, format.precision);
  const auto& [eye, view] = segment;
  camera.eye = eye;
  camera.look_at = {eye.x + view.x, eye.y + view.y, eye.z + view.z};
  return camera.eye != from || camera.look_at != to;
}

/// If an image has an odd number of pixels across and down, or an even one with corners as samples,
/// the middle one is on the axis of a symmetric window.
void add_middle_pixel(Case& the_case) {
  const Pixel middle = {the_case.scene.camera->width / 2, the_case.scene.camera->height / 2};
  if (std::ranges::find(the_case.pixels, middle) == the_case.pixels.end()) {
    the_case.pixels.push_back(middle);
  }
}

}  // namespace

Ray with_unit_direction(Ray ray, Precision precision) {
  auto& [x, y, z] = ray.direction;
  if (is_unit(ray.direction, precision)) return ray;
  make_unit(ray.direction);
  for (double* one : {&x, &y, &z}) *one = scene::rounded_to(precision, *one);
  return ray;
}

RoundedCase rounded_case(Case the_case, InputFormat format) {
  const Precision precision = format.precision;
  RoundedCase result;
  InputFormat unrounded = format;
  unrounded.precision = Precision::kDouble;
  std::optional<Camera> given = the_case.scene.camera;
  const bool is_other_window = given && fit_window(*given, unrounded);
  if (fit_spheres(the_case.scene, format)) result.replaced = accepted(format.placement);
  if (format.middle_pixel && the_case.scene.camera) add_middle_pixel(the_case);
  scene::Samples& samples = the_case.scene.conventions.samples;
  if (!format.corners && samples == scene::Samples::kCorners) samples = scene::Samples::kCentres;
  if (format.unit_directions) {
    for (Ray& ray : the_case.scene.rays) {
      if (is_unit(ray.direction, precision)) continue;
      make_unit(ray.direction);
      ++result.made_unit;
    }
  }
  if (format.segments) {
    for (Ray& ray : the_case.scene.rays) {
      ray = rounded_ray(ray, format);
      if (!scene::defects(ray).empty()) {
        result.reason = "a segment's end rounds to its origin, or out of range";
        return result;
      }
    }
  }
  if (precision == Precision::kSingle) {
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
  }
  if (the_case.scene.camera) fit_window(*the_case.scene.camera, format);
  if (is_other_window) result.replaced = accepted(format.windows);
  const bool moved = fit_view(the_case.scene, format);
  if (moved && format.view == contract::View::kCentre) result.replaced = kLooksAtCentre;
  if (precision == Precision::kSingle || !result.replaced.empty() || moved) {
    const auto defects = scene::defects(the_case.scene);
    if (!defects.empty()) {
      result.reason = result.changed > 0 ? "rounded to floats: " : "as the candidate accepts it: ";
      result.reason +=
          defects.front().field + " = " + defects.front().value + ": " + defects.front().what;
      return result;
    }
  }
  if (!result.replaced.empty() && !is_of_format(the_case.scene, format)) {
    result.reason = "no scene near this one is of the format and has " + result.replaced;
    return result;
  }
  result.the_case = std::move(the_case);
  return result;
}

Ray rounded_ray(Ray ray, InputFormat format) {
  const Precision precision = format.precision;
  if (format.unit_directions && !is_unit(ray.direction, precision)) make_unit(ray.direction);
  for (double* x : {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x, &ray.direction.y,
                    &ray.direction.z}) {
    *x = scene::rounded_to(precision, *x);
  }
  if (format.segments) make_segment(ray, precision);
  return ray;
}

RoundedCase rounded_scene(Scene scene, InputFormat format) {
  RoundedCase rounded = rounded_case({std::move(scene), {}}, format);
  if (rounded.replaced.empty()) return rounded;
  rounded.the_case.reset();
  rounded.reason = "the candidate accepts only " + rounded.replaced;
  return rounded;
}

bool is_of_format(const Scene& scene, InputFormat format) {
  const Precision precision = format.precision;
  Scene copy = scene;
  bool all = std::ranges::all_of(scene.rays, [&](const Ray& ray) {
    return (!format.unit_directions || is_unit(ray.direction, precision)) &&
           (!format.segments || rounded_ray(ray, format) == ray);
  });
  all = all && !(copy.camera && fit_window(*copy.camera, format));
  all = all && !fit_view(copy, format) && !fit_spheres(copy, format);
  if (precision == Precision::kDouble || !all) return all;
  const auto look = [&](const double& x) { all = all && scene::rounded_to(precision, x) == x; };
  for_each_number(copy, look);
  look(scene.conventions.valid.t_min);
  look(scene.conventions.valid.t_max);
  return all;
}

}  // namespace raycheck::properties
