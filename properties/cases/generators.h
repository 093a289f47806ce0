#pragma once

// Helpers of the sources of cases. Internal to properties/. Except for Random::power_of_ten(), no
// function called here differs between machines.

#include "properties/case.h"
#include "properties/cases/random.h"
#include "scene/validate.h"

namespace raycheck::properties {

/// 10^k rounded once, |k| <= 22.
double power_of_ten(int k);

/// The factor of severity k, random in [0.5, 2) 10^k: cases of one severity differ.
double about_ten_to(Random& random, int k);
/// The same for a fraction: in [0.4, 0.9) 10^-k, so below 1 at severity 0.
double share_of(Random& random, int k);
double signed_share_of(Random& random, int k);

double dot(const scene::Vector3& a, const scene::Vector3& b);
double length(const scene::Vector3& v);
scene::Point3 along(const scene::Point3& origin, double t, const scene::Vector3& direction);
scene::Vector3 times(double factor, const scene::Vector3& v);
scene::Vector3 cross(const scene::Vector3& a, const scene::Vector3& b);
/// A camera's axes.
struct Axes {
  explicit Axes(const scene::Camera& camera);
  scene::Vector3 u, v, w;
};

/// A unit vector at right angles to `direction`.
scene::Vector3 across(Random& random, const scene::Vector3& direction);

/// For given doubles, accurate to a few units in the last place despite cancellation: sources with
/// severities finer than the rounding of a sphere's centre choose the radius to fit.
double distance_between(const scene::Point3& from, const scene::Point3& to);  ///< |T|
double impact_parameter(const scene::Ray& ray, const scene::Point3& centre);  ///< |T x d|/|d|
/// T.d/|d|, accurate relative to |T|.
double axial_distance(const scene::Ray& ray, const scene::Point3& centre);

/// The smallest double times 2^1074 is 1.
inline constexpr int kMostBinades = 1074;

scene::Conventions any_conventions(Random& random);

/// Every length of the scene times 2^exponent, rounded once where it leaves the normal range.
void scale_lengths(scene::Scene& scene, int exponent);

/// A ray and its unit direction.
struct Line {
  scene::Ray ray;
  scene::Vector3 unit;
};

/// Within 10 of the world's origin.
scene::Point3 ordinary_origin(Random& random);

/// A ray in a random direction, half of the time not a unit one.
Line any_line(Random& random, const scene::Point3& origin);

/// A sphere `distance` along the line and `impact` off it.
scene::Sphere sphere_off(Random& random, const Line& line, double distance, double impact,
                         double radius);

/// One ray from `origin`, and one to three spheres that make_sphere(random, line) places.
template <class MakeSphere>
Case ray_case(Random& random, const scene::Point3& origin, MakeSphere make_sphere) {
  Case result;
  result.scene.conventions = any_conventions(random);
  const Line line = any_line(random, origin);
  result.scene.rays.push_back(line.ray);
  const auto spheres = random.one_in(2) ? 1 : random.integer(2, 3);
  for (std::int64_t k = 0; k < spheres; ++k) {
    result.scene.spheres.push_back(make_sphere(random, line));
  }
  return result;
}

/// An eye within 10 of the world's origin, bounds of about |near|, a small image.
scene::Camera ordinary_camera(Random& random);
/// Makes the bounds symmetric half of the time, mirrors the image now and then.
void vary_bounds(Random& random, scene::Camera& camera);
/// A few pixels of the camera: a corner now and then, otherwise anywhere.
std::vector<scene::Pixel> some_pixels(Random& random, const scene::Camera& camera);
/// `count` spheres about where the camera looks: hit by some pixels, missed by others.
void add_spheres_in_view(Random& random, std::int64_t count, scene::Scene& scene);

/// Calls fill(random, case) until the case is valid; its conventions are set first.
template <class Fill>
Case valid_case(std::uint64_t seed, Fill fill) {
  Random random(seed);
  for (;;) {
    Case result;
    result.scene.conventions = any_conventions(random);
    fill(random, result);
    if (scene::defects(result.scene).empty()) return result;
  }
}

}  // namespace raycheck::properties
