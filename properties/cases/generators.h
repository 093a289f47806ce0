#pragma once

// Helpers of the sources of cases. Internal to properties/. All functions called here give the same
// results on every machine, except Random::power_of_ten().

#include "properties/case.h"
#include "properties/cases/random.h"
#include "scene/validate.h"

namespace raycheck::properties {

/// 10^k rounded once, |k| <= 22.
double power_of_ten(int k);

/// A random factor for severity k, in [0.5, 2) 10^k.
double about_ten_to(Random& random, int k);
/// A random fraction for severity k, in [0.4, 0.9) 10^-k: below 1 even at severity 0.
double share_of(Random& random, int k);
double signed_share_of(Random& random, int k);

double dot(const Vector3& a, const Vector3& b);
double length(const Vector3& v);
Point3 along(const Point3& origin, double t, const Vector3& direction);
Vector3 times(double factor, const Vector3& v);
Vector3 cross(const Vector3& a, const Vector3& b);
/// The coordinates in one of the three orders that keep handedness.
template <class Triple>
Triple turned(Triple v, std::int64_t turns) {
  for (; turns > 0; --turns) v = {v.z, v.x, v.y};
  return v;
}
/// A camera's axes.
struct Axes {
  explicit Axes(const Camera& camera);
  Vector3 u, v, w;
};

/// A unit vector at right angles to `direction`.
Vector3 across(Random& random, const Vector3& direction);

/// These three are accurate to a few ulp despite cancellation. If a severity is finer than the
/// rounding of a sphere's centre, the source fits the radius to the rounded centre.
double distance_between(const Point3& from, const Point3& to);  ///< |T|
double impact_parameter(const Ray& ray, const Point3& centre);  ///< |T x d|/|d|
/// T.d/|d|, accurate relative to |T|.
double axial_distance(const Ray& ray, const Point3& centre);

/// The smallest double times 2^1074 is 1.
inline constexpr int kMostBinades = 1074;

Conventions any_conventions(Random& random);

/// Multiplies every length of the scene by 2^exponent; lengths that become subnormal are rounded
/// once.
void scale_lengths(Scene& scene, int exponent);

/// A ray and its unit direction.
struct Line {
  Ray ray;
  Vector3 unit;
};

/// Within 10 of the world's origin.
Point3 ordinary_origin(Random& random);

/// A ray in a random direction; half of the time the direction is not a unit vector.
Line any_line(Random& random, const Point3& origin);

/// A sphere whose centre is `distance` along the line and `impact` off it.
Sphere sphere_off(Random& random, const Line& line, double distance, double impact, double radius);

/// One ray from `origin`, and one to three spheres that make_sphere(random, line) places.
template <class MakeSphere>
Case ray_case(Random& random, const Point3& origin, MakeSphere make_sphere) {
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
Camera ordinary_camera(Random& random);
/// Makes the bounds symmetric half of the time, and mirrors the image now and then.
void vary_bounds(Random& random, Camera& camera);
/// A few pixels of the camera: a corner now and then, otherwise anywhere.
std::vector<Pixel> some_pixels(Random& random, const Camera& camera);
/// Adds `count` spheres about where the camera looks; some pixels hit them, others miss.
void add_spheres_in_view(Random& random, std::int64_t count, Scene& scene);

/// Sets random conventions and calls fill(random, case), until the case is valid.
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
