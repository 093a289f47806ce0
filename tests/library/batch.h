#pragma once

// Rays and spheres for the tests of raycheck/batch.h.

#include <raycheck/cases.h>
#include <raycheck/exact.h>

#include <array>
#include <random>
#include <raycheck/batch.hpp>

#include "tests/testing.h"

namespace raycheck::tests {

/// Rays and spheres in arrays, and the answers to all of them.
struct Many {
  std::vector<Ray> rays;
  std::vector<Sphere> spheres;
  std::vector<std::uint8_t> hit_class, root;
  std::vector<double> s, s_error;
  std::array<std::vector<double>, 3> point, point_error;
  raycheck_options options = batch::options();

  void add(const Ray& ray, const Sphere& sphere) {
    rays.push_back(ray);
    spheres.push_back(sphere);
  }
  raycheck_rays given() const {
    raycheck_rays given = {};
    given.origin = batch::points<Ray>(rays, &Ray::origin);
    given.direction = batch::points<Ray>(rays, &Ray::direction);
    return given;
  }
  raycheck_spheres balls() const {
    raycheck_array radius = {};
    if (!spheres.empty()) {
      radius = {&spheres[0].radius, spheres.size(), sizeof(Sphere), RAYCHECK_FLOAT64};
    }
    return {batch::points<Sphere>(spheres, &Sphere::centre), radius};
  }
  raycheck_decided to(std::size_t count) {
    hit_class.assign(count, 77);
    root.assign(count, 77);
    for (auto* one : {&s, &s_error, &point[0], &point[1], &point[2], &point_error[0],
                      &point_error[1], &point_error[2]}) {
      one->assign(count, 77);
    }
    return {
        batch::output(hit_class), batch::output(root),
        batch::output(s),         batch::output(point[0], point[1], point[2]),
        batch::output(s_error),   batch::output(point_error[0], point_error[1], point_error[2])};
  }
  std::int32_t decide() {
    const raycheck_rays its_rays = given();
    const raycheck_spheres its_spheres = balls();
    const bool every = options.pairing == RAYCHECK_EACH_WITH_EVERY;
    const raycheck_decided answers = to(rays.size() * (every ? spheres.size() : 1));
    return raycheck_decide(&its_rays, &its_spheres, &options, &answers, &batch::error());
  }
};

inline raycheck_asked asked_of(const Conventions& c) {
  return {{static_cast<int>(c.rows), static_cast<int>(c.samples), static_cast<int>(c.origin),
           static_cast<int>(c.root), static_cast<int>(c.tangent)},
          {c.valid.t_min, c.valid.t_max, static_cast<int>(c.valid.ends),
           static_cast<int>(c.valid.unit), static_cast<int>(c.valid.culling)}};
}

/// The error of a value, and the least gap of doubles around the exact number.
inline double error_of(double value, const exact::Number& number) {
  const exact::Interval around = number.interval();
  const double nearer =
      std::abs(around.lower) < std::abs(around.upper) ? around.lower : around.upper;
  if (nearer == 0) return std::max(std::abs(value - around.lower), std::abs(value - around.upper));
  const double ulp = std::nextafter(std::abs(nearer), kInfinity) - std::abs(nearer);
  return number.ulp_error(value) * ulp;
}

/// Rays of every source of given rays, with their spheres. RAYCHECK_BATCH_CASES: of each source.
inline Many hard_rays(std::uint64_t first = 0) {
  const char* const asked = std::getenv("RAYCHECK_BATCH_CASES");
  const std::uint64_t cases = asked == nullptr ? 6000 : std::stoull(asked);
  Many many;
  for (const Source& source : sources()) {
    if (source.has_camera) continue;
    for (std::uint64_t k = first; k < first + cases; ++k) {
      const auto severity = static_cast<int>(k % static_cast<std::uint64_t>(source.highest + 1));
      const Case one = make_case(source.name, 5, k, severity);
      for (const Sphere& sphere : one.scene.spheres) many.add(one.scene.rays.front(), sphere);
    }
  }
  return many;
}

inline Camera small_camera() {
  return {{1, 2, 30}, {0, 0, 0}, {0, 1, 0.2}, -1, -.3, .3, -.2, .2, 48, 35};
}
inline raycheck_camera in_c(const Camera& c) {
  const auto triple = [](const Vector& v) { return raycheck_vector{v.x, v.y, v.z}; };
  return {triple(c.eye), triple(c.look_at), triple(c.up), c.near_plane, c.left,
          c.right,       c.bottom,          c.top,        c.width,      c.height};
}

/// Spheres in view, some of them twice, and integers that meet.
inline std::vector<Sphere> some_spheres(int count) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> at(-5, 5);
  std::vector<Sphere> spheres;
  for (int k = 0; k < count; ++k) {
    const Sphere one{{at(random), at(random), at(random)}, 0.3 + std::abs(at(random)) / 8};
    spheres.push_back(one);
    if (k % 7 == 0) spheres.push_back(one);
  }
  return spheres;
}

}  // namespace raycheck::tests
