#include "properties/case_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "properties/random.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

using scene::Camera;
using scene::Point3;
using scene::Ray;
using scene::Scene;
using scene::Sphere;
using scene::Vector3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Point3 along(const Point3& origin, double t, const Vector3& direction) {
  return {origin.x + t * direction.x, origin.y + t * direction.y, origin.z + t * direction.z};
}

Vector3 times(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

/// A unit vector across `direction`.
Vector3 across(Random& random, const Vector3& direction) {
  for (;;) {
    const Vector3 v = random.direction();
    const Vector3 cross = {v.y * direction.z - v.z * direction.y,
                           v.z * direction.x - v.x * direction.z,
                           v.x * direction.y - v.y * direction.x};
    const double length = std::hypot(cross.x, cross.y, cross.z);
    if (length > 0.1) return times(1 / length, cross);
  }
}

scene::Conventions any_conventions(Random& random) {
  scene::Conventions conventions;
  if (random.one_in(2)) conventions.rows = scene::Rows::kTopFirst;
  if (random.one_in(3)) conventions.samples = scene::Samples::kCentres;
  if (random.one_in(3)) conventions.origin = scene::Origin::kFocal;
  if (random.one_in(4)) conventions.root = scene::Root::kSmaller;
  if (random.one_in(4)) conventions.tangent = scene::Tangent::kMiss;
  if (random.one_in(8)) conventions.tangent = scene::Tangent::kEither;
  return conventions;
}

/// A few pixels of the camera: a corner now and then, otherwise anywhere.
std::vector<scene::Pixel> some_pixels(Random& random, const Camera& camera) {
  std::vector<scene::Pixel> pixels;
  const auto count = random.integer(1, 4);
  for (std::int64_t k = 0; k < count; ++k) {
    pixels.push_back({random.integer(0, camera.width - 1), random.integer(0, camera.height - 1)});
  }
  if (random.one_in(3)) pixels.push_back({0, 0});
  return pixels;
}

/// A sphere about where the camera looks: hit by some pixels, missed by others.
Sphere sphere_in_view(Random& random, const Camera& camera) {
  const Vector3 view = camera.look_at - camera.eye;
  const double distance = std::hypot(view.x, view.y, view.z);
  const double depth = random.between(0.2, 4);
  const double radius = distance * depth * random.between(0.05, 0.6);
  Point3 centre = along(camera.eye, depth, view);
  if (random.one_in(8)) centre = along(camera.eye, -depth, view);  // behind
  if (random.one_in(8)) centre = camera.eye;                       // around the eye
  const double off = radius * random.unit() * 1.5;
  return {along(centre, off, random.direction()), radius};
}

template <class MakeCamera>
Case camera_case(std::uint64_t seed, MakeCamera make_camera) {
  Random random(seed);
  for (;;) {
    Case result;
    result.scene.conventions = any_conventions(random);
    Camera camera = make_camera(random);
    if (random.one_in(2)) {
      camera.right = -camera.left;
      camera.top = -camera.bottom;
    }
    if (random.one_in(8)) std::swap(camera.left, camera.right);
    result.scene.camera = camera;
    const auto spheres = random.integer(0, 3);
    for (std::int64_t k = 0; k < spheres; ++k) {
      result.scene.spheres.push_back(sphere_in_view(random, camera));
    }
    if (!scene::problems(result.scene).empty()) continue;
    result.pixels = some_pixels(random, camera);
    return result;
  }
}

Camera ordinary_camera(Random& random) {
  Camera camera;
  camera.eye = along({}, 10, random.in_cube(1));
  const double distance = random.between(1, 10);
  camera.look_at = along(camera.eye, distance, random.direction());
  const double up_length = random.between(0.5, 2);
  camera.up = times(up_length, random.direction());
  camera.near = -random.power_of_ten(-1, 1);
  camera.left = camera.near * random.between(0.2, 1.5);
  camera.bottom = camera.near * random.between(0.2, 1.5);
  camera.right = -camera.near * random.between(0.2, 1.5);
  camera.top = -camera.near * random.between(0.2, 1.5);
  camera.width = random.integer(2, 16);
  camera.height = random.integer(2, 16);
  return camera;
}

Case cameras(std::uint64_t seed) { return camera_case(seed, ordinary_camera); }

/// Small integers, axis-aligned views, odd images: what people try first, full of exact ties.
Case plain_cameras(std::uint64_t seed) {
  Case result = camera_case(seed, [](Random& random) {
    Camera camera;
    const Vector3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto view = random.integer(0, 2);
    if (!random.one_in(3)) {
      camera.eye = {random.small_integer(8), random.small_integer(8), random.small_integer(8)};
    }
    const double side = random.sign();
    camera.look_at =
        along(camera.eye, side * static_cast<double>(random.integer(1, 9)), axes[view]);
    camera.up = axes[(view + random.integer(1, 2)) % 3];
    camera.near = -static_cast<double>(random.integer(1, 4));
    camera.left = -static_cast<double>(random.integer(1, 6));
    camera.bottom = -static_cast<double>(random.integer(1, 6));
    camera.right = static_cast<double>(random.integer(1, 6));
    camera.top = static_cast<double>(random.integer(1, 6));
    camera.width = random.integer(2, 9);
    camera.height = random.integer(2, 9);
    return camera;
  });
  Random random(~seed);
  for (Sphere& sphere : result.scene.spheres) {
    for (double* x : {&sphere.centre.x, &sphere.centre.y, &sphere.centre.z}) *x = std::round(*x);
    sphere.radius = std::ceil(sphere.radius);
  }
  if (!result.scene.spheres.empty() && random.one_in(3)) {
    result.scene.spheres.push_back(result.scene.spheres.front());  // a tie for the nearest
  }
  return result;
}

/// Eyes far from the world's origin and up vectors near the view direction: ill-conditioned frames.
Case far_cameras(std::uint64_t seed) {
  return camera_case(seed, [](Random& random) {
    Camera camera = ordinary_camera(random);
    const double distance = random.power_of_ten(1, 8);
    const Vector3 shift = times(distance, random.direction());
    camera.eye = along(camera.eye, 1, shift);
    camera.look_at = along(camera.look_at, 1, shift);
    if (random.one_in(2)) {
      const Vector3 view = camera.eye - camera.look_at;
      const double angle = random.power_of_ten(-8, 0);
      const Vector3 off = times(angle, random.direction());
      camera.up = {view.x + off.x, view.y + off.y, view.z + off.z};
    }
    return camera;
  });
}

/// Cameras scaled to the ends of the double range, image planes behind the eye, images one pixel
/// wide.
Case extreme_cameras(std::uint64_t seed) {
  Random random(~seed);
  for (;;) {
    Case result = cameras(random.bits());
    Camera& camera = *result.scene.camera;
    const int exponent = random.one_in(4) ? 0 : static_cast<int>(random.integer(-1060, 1010));
    const auto scale = [exponent](double& x) { x = std::ldexp(x, exponent); };
    for (double* x : {&camera.eye.x, &camera.eye.y, &camera.eye.z, &camera.look_at.x,
                      &camera.look_at.y, &camera.look_at.z, &camera.near, &camera.left,
                      &camera.right, &camera.bottom, &camera.top}) {
      scale(*x);
    }
    for (Sphere& sphere : result.scene.spheres) {
      for (double* x : {&sphere.centre.x, &sphere.centre.y, &sphere.centre.z, &sphere.radius}) {
        scale(*x);
      }
    }
    const int up_exponent = random.one_in(2) ? 0 : static_cast<int>(random.integer(-1060, 1010));
    for (double* x : {&camera.up.x, &camera.up.y, &camera.up.z}) *x = std::ldexp(*x, up_exponent);
    if (random.one_in(4)) camera.near = -camera.near;
    if (random.one_in(4)) {
      result.scene.conventions.samples = scene::Samples::kCentres;
      (random.one_in(2) ? camera.width : camera.height) = 1;
      result.pixels = {{0, 0}};
    }
    if (scene::problems(result.scene).empty()) return result;
  }
}

/// Where a ray is aimed at a sphere.
struct Aim {
  double distance;  ///< From the origin to the centre's foot on the line.
  double impact;    ///< From the line to the centre.
  double radius;
};

/// One ray and one to three spheres met as `aim` says, in a random position; directions need not be
/// unit.
template <class MakeAim>
Case ray_case(std::uint64_t seed, MakeAim make_aim) {
  Random random(seed);
  for (;;) {
    Case result;
    result.scene.conventions = any_conventions(random);
    Ray ray;
    const Vector3 unit = random.direction();
    const double from_origin = random.between(0, 10);
    ray.origin = along({}, from_origin, random.direction());
    ray.direction = random.one_in(2) ? unit : times(random.power_of_ten(-2, 2), unit);
    const auto spheres = random.one_in(2) ? 1 : random.integer(2, 3);
    for (std::int64_t k = 0; k < spheres; ++k) {
      const Aim aim = make_aim(random);
      const Point3 foot = along(ray.origin, aim.distance, unit);
      result.scene.spheres.push_back({along(foot, aim.impact, across(random, unit)), aim.radius});
    }
    result.scene.rays.push_back(ray);
    if (scene::problems(result.scene).empty()) return result;
  }
}

Case rays(std::uint64_t seed) {
  return ray_case(seed, [](Random& random) {
    const double radius = random.power_of_ten(-1, 1);
    return Aim{random.between(-2, 10), radius * random.between(0, 1.6), radius};
  });
}

Case far(std::uint64_t seed) {
  return ray_case(seed, [](Random& random) {
    const double radius = random.power_of_ten(-2, 1);
    return Aim{radius * random.power_of_ten(1, 12), radius * random.between(0, 1.6), radius};
  });
}

Case grazing(std::uint64_t seed) {
  return ray_case(seed, [](Random& random) {
    const double radius = random.power_of_ten(-1, 1);
    const double distance = radius * random.power_of_ten(-1, 3);
    return Aim{random.one_in(8) ? -distance : distance,
               radius * (1 + random.signed_power_of_ten(-15, -1)), radius};
  });
}

Case surface(std::uint64_t seed) {
  return ray_case(seed, [](Random& random) {
    const double radius = random.power_of_ten(-1, 1);
    const double impact = radius * random.between(0, 0.99);
    const double half_chord = std::sqrt(radius * radius - impact * impact);
    const double off = random.one_in(4) ? 0 : random.signed_power_of_ten(-15, 0);
    return Aim{random.sign() * half_chord * (1 + off), impact, radius};
  });
}

/// Axis-aligned rays at integer distances: exact tangents, equal spheres, and their neighbours a
/// few ulps away.
Case ties(std::uint64_t seed) {
  Random random(seed);
  const double significand = static_cast<double>(random.integer(1, 8));
  const double radius = std::ldexp(significand, static_cast<int>(random.integer(-3, 3)));
  Case result;
  result.scene.conventions = any_conventions(random);
  double impact = random.one_in(4) ? radius * 0.5 : radius;
  for (auto steps = random.one_in(2) ? 0 : random.integer(-4, 4); steps != 0;
       steps += steps < 0 ? 1 : -1) {
    impact = std::nextafter(impact, steps < 0 ? 0 : kInfinity);
  }
  const double distance = random.small_integer(20);
  Vector3 direction = {random.one_in(2) ? 1.0 : static_cast<double>(random.integer(1, 9)), 0, 0};
  Point3 origin = {0, impact, 0};
  Point3 centre = {distance, 0, 0};
  for (auto turns = random.integer(0, 2); turns > 0; --turns) {
    direction = {direction.z, direction.x, direction.y};
    origin = {origin.z, origin.x, origin.y};
    centre = {centre.z, centre.x, centre.y};
  }
  result.scene.rays.push_back({origin, direction});
  result.scene.spheres.push_back({centre, radius});
  if (random.one_in(2)) {
    const double other = random.one_in(2) ? radius : std::nextafter(radius, kInfinity);
    result.scene.spheres.push_back({centre, other});
  }
  return result;
}

/// Ordinary rays with every length scaled by a power of two, and the direction by another, to the
/// ends of the double range.
Case magnitudes(std::uint64_t seed) {
  Random random(~seed);
  for (;;) {
    Case result = rays(random.bits());
    const int exponent = static_cast<int>(random.integer(-1070, 1000));
    const int direction_exponent = static_cast<int>(random.integer(-1070, 1000));
    const auto scale = [](double& x, int by) { x = std::ldexp(x, by); };
    for (Ray& ray : result.scene.rays) {
      for (double* x : {&ray.origin.x, &ray.origin.y, &ray.origin.z}) scale(*x, exponent);
      for (double* x : {&ray.direction.x, &ray.direction.y, &ray.direction.z}) {
        scale(*x, direction_exponent);
      }
    }
    for (Sphere& sphere : result.scene.spheres) {
      for (double* x : {&sphere.centre.x, &sphere.centre.y, &sphere.centre.z, &sphere.radius}) {
        scale(*x, exponent);
      }
    }
    if (scene::problems(result.scene).empty()) return result;
  }
}

constexpr CaseSource kSources[] = {
    {"cameras", "ordinary cameras and spheres in view", true, cameras},
    {"plain-cameras", "axis-aligned cameras of small integers, with ties", true, plain_cameras},
    {"far-cameras", "eyes far from the origin, up near the view direction", true, far_cameras},
    {"extreme-cameras", "cameras scaled to the ends of the double range", true, extreme_cameras},
    {"rays", "ordinary rays and spheres", false, rays},
    {"far", "spheres 1e1 to 1e12 radii away", false, far},
    {"grazing", "impact parameters r (1 +- 10^-k)", false, grazing},
    {"surface", "origins on, near and inside the sphere", false, surface},
    {"ties", "exact tangents and equal spheres, and their neighbours in ulps", false, ties},
    {"magnitudes", "rays scaled to the ends of the double range", false, magnitudes},
};

}  // namespace

std::span<const CaseSource> case_sources() { return kSources; }

const CaseSource* find_case_source(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kSources), std::end(kSources),
                                         [&](const CaseSource& s) { return s.name == name; });
  return found == std::end(kSources) ? nullptr : found;
}

}  // namespace raycheck::properties
