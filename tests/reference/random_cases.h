#pragma once

// Cameras, rays and spheres for the tests of reference/: small integers, ordinary sizes, all sizes.

#include "properties/cases/random.h"
#include "reference/exact_ray.h"
#include "scene/camera.h"
#include "scene/number.h"
#include "scene/validate.h"
#include "tests/numbers.h"
#include "tests/standard.h"

namespace raycheck::reference {

using properties::Random;

inline const Intersection kSmallerHit{HitClass::kHit, WhichRoot::kSmaller};
inline const Intersection kLargerHit{HitClass::kHit, WhichRoot::kLarger};
inline const Intersection kTangent{HitClass::kTangent, WhichRoot::kSmaller};
inline const scene::Sphere kUnit{{0, 0, 0}, 1};

/// A finite double. All exponents are equally likely; 0 and both ends of the range occur, too.
inline double any_double(Random& random) {
  if (random.one_in(8)) return 0;
  if (random.one_in(16)) return random.sign() * kSmallest;
  if (random.one_in(16)) return random.sign() * kLargest;
  if (random.one_in(4)) return random.small_integer(3);
  for (;;) {
    const auto value = std::bit_cast<double>(random.bits());
    if (std::isfinite(value)) return value;
  }
}

/// The kind of random numbers.
enum class Sizes { kSmallIntegers, kOrdinary, kAll };

inline double number(Random& random, Sizes sizes, std::int64_t size = 9) {
  if (sizes == Sizes::kSmallIntegers) return random.small_integer(size);
  if (sizes == Sizes::kAll) return any_double(random);
  return random.between(-static_cast<double>(size), static_cast<double>(size));
}

template <class Triple>
Triple triple(Random& random, Sizes sizes, std::int64_t size = 9) {
  const double x = number(random, sizes, size);
  const double y = number(random, sizes, size);
  return {x, y, number(random, sizes, size)};
}

/// With kAll, about half of the spheres are about as large as their centres are far, so that rays
/// meet some.
inline scene::Sphere random_sphere(Random& random, Sizes sizes) {
  const auto centre = triple<scene::Point3>(random, sizes, 12);
  if (sizes == Sizes::kAll && random.one_in(2)) {
    const double distance = std::hypot(centre.x, centre.y, centre.z) * random.between(0.5, 2);
    if (std::isfinite(distance)) return {centre, distance};
  }
  return {centre, std::abs(number(random, sizes, 12))};
}

inline scene::Ray random_ray(Random& random, Sizes sizes) {
  for (;;) {
    const scene::Ray ray{triple<scene::Point3>(random, sizes),
                         triple<scene::Vector3>(random, sizes)};
    if (scene::defects(ray).empty()) return ray;
  }
}

inline scene::Camera random_camera(Random& random, Sizes sizes) {
  for (;;) {
    scene::Camera camera;
    camera.eye = triple<scene::Point3>(random, sizes);
    camera.look_at = triple<scene::Point3>(random, sizes);
    camera.up = triple<scene::Vector3>(random, sizes);
    camera.near = -std::abs(number(random, sizes));
    for (double* bound : {&camera.left, &camera.right, &camera.bottom, &camera.top}) {
      *bound = number(random, sizes);
    }
    camera.width = random.integer(2, 9);
    camera.height = random.integer(2, 9);
    if (scene::defects(camera).empty()) return camera;
  }
}

inline scene::Pixel random_pixel(Random& random, const scene::Camera& camera) {
  const std::int64_t i = random.integer(0, camera.width - 1);
  return {i, random.integer(0, camera.height - 1)};
}

inline scene::Conventions random_conventions(Random& random) {
  scene::Conventions conventions;
  if (random.one_in(2)) conventions.rows = scene::Rows::kTopFirst;
  const std::int64_t samples = random.integer(0, 3);
  if (samples == 0) conventions.samples = scene::Samples::kCentres;
  if (samples == 2) conventions.samples = scene::Samples::kCorners;
  if (random.one_in(2)) conventions.origin = scene::Origin::kFocal;
  return conventions;
}

/// The inputs of a camera and spheres, in the order of InputChange.
inline std::vector<double*> inputs_of(scene::Camera& camera, std::vector<scene::Sphere>& spheres) {
  auto& [eye, look_at, up, near, far, left, right, bottom, top, width, height] = camera;
  std::vector<double*> result = {&eye.x, &eye.y, &eye.z, &look_at.x, &look_at.y, &look_at.z, &up.x,
                                 &up.y,  &up.z,  &near,  &left,      &right,     &bottom,    &top};
  for (auto& [centre, radius] : spheres) {
    for (double* x : {&centre.x, &centre.y, &centre.z, &radius}) result.push_back(x);
  }
  return result;
}

template <class Triple>
std::array<double*, 3> numbers_of(Triple& v) {
  return {&v.x, &v.y, &v.z};
}

/// `value` moved by `steps` doubles.
inline double nudged(double value, std::int64_t steps) {
  for (; steps > 0; --steps) value = std::nextafter(value, kInfinity);
  for (; steps < 0; ++steps) value = std::nextafter(value, -kInfinity);
  return value;
}

// Text of counterexamples that can be pasted into tests.
template <class Triple>
std::string spelled(const Triple& v) {
  return "{" + scene::hexfloat(v.x) + ", " + scene::hexfloat(v.y) + ", " + scene::hexfloat(v.z) +
         "}";
}
inline std::string spelled(const scene::Ray& ray) {
  return "ray {" + spelled(ray.origin) + ", " + spelled(ray.direction) + "}";
}
inline std::string spelled(const scene::Sphere& sphere) {
  return " sphere {" + spelled(sphere.centre) + ", " + scene::hexfloat(sphere.radius) + "}";
}
inline std::string spelled(const scene::Camera& camera) {
  std::string text =
      "camera {" + spelled(camera.eye) + ", " + spelled(camera.look_at) + ", " + spelled(camera.up);
  for (const double value : {camera.near, camera.left, camera.right, camera.bottom, camera.top}) {
    text += ", " + scene::hexfloat(value);
  }
  return text + ", " + std::to_string(camera.width) + " x " + std::to_string(camera.height) + "}";
}

}  // namespace raycheck::reference
