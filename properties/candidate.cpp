#include "properties/candidate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/validate.h"

namespace raycheck::properties {
namespace {

template <class Triple>
double length(const Triple& v) {
  return std::hypot(v.x, v.y, v.z);
}

}  // namespace

bool lengths_are_within(const Scene& scene, double smallest, double largest) {
  const auto within = [&](double size) {
    return size == 0 || (std::abs(size) >= smallest && std::abs(size) <= largest);
  };
  bool inside = true;
  const auto require = [&](double size) { inside = inside && within(size); };
  const auto require_distance_of_points = [&](const Point3& from) {
    for (const Sphere& sphere : scene.spheres) {
      if (sphere.radius == 0) require(length(sphere.centre - from));
    }
  };
  if (scene.camera) {
    const Camera& camera = *scene.camera;
    require(length(camera.eye - camera.look_at));
    require(length(camera.up));
    require(camera.near);
    require(camera.right - camera.left);
    require(camera.top - camera.bottom);
    require_distance_of_points(camera.eye);
    for (const double size : {length(camera.eye), length(camera.look_at), camera.left, camera.right,
                              camera.bottom, camera.top}) {
      inside = inside && std::abs(size) <= largest;
    }
  }
  for (const Ray& ray : scene.rays) {
    require(length(ray.direction));
    inside = inside && length(ray.origin) <= largest;
    require_distance_of_points(ray.origin);
  }
  for (const Sphere& sphere : scene.spheres) {
    require(sphere.radius);
    inside = inside && length(sphere.centre) <= largest;
  }
  return inside;
}

bool is_inside_domain(const Domain& domain, const Scene& scene) {
  return lengths_are_within(scene, domain.smallest_length, domain.largest_length) &&
         (!scene.camera ||
          lengths_are_within(scene, domain.smallest_camera_length, domain.largest_camera_length));
}

Candidate declaring(const contract::Declarations& declared, std::string name,
                    const Candidate& bounds) {
  Candidate candidate;
  candidate.name = std::move(name);
  candidate.declared = declared.conventions;
  candidate.refuses = false;
  candidate.level = declared.level;
  candidate.max_error = bounds.max_error;
  candidate.max_error_end_to_end = bounds.max_error_end_to_end;
  candidate.unit_roundoff = bounds.unit_roundoff;
  candidate.smallest_length = std::max(kSmallestJudgedLength, declared.lengths.smallest);
  candidate.smallest_camera_length = candidate.smallest_length;
  candidate.largest_length = declared.lengths.largest;
  candidate.interface = declared.interface;
  candidate.tolerances = declared.tolerances;
  candidate.corners = declared.corners;
  return candidate;
}

bool is_problem(const Case& the_case, const DeclaredConventions& declared) {
  if (!declared.samples && !declared.valid) return true;
  Scene scene = the_case.scene;
  scene.conventions = declared.over(scene.conventions);
  return scene::defects(scene).empty();
}

Candidate judged_in(Precision precision, Candidate candidate) {
  if (precision == Precision::kDouble) return candidate;
  const double roundoff = scene::unit_roundoff(precision);
  const double coarser =
      std::max(1.0, std::min(candidate.unit_roundoff, roundoff) / kDoubleRoundoff);
  for (auto* bounds : {&candidate.max_error, &candidate.max_error_end_to_end}) {
    for (auto& bound : *bounds) {
      if (bound) *bound /= coarser;
    }
  }
  candidate.precision = precision;
  candidate.unit_roundoff = std::max(candidate.unit_roundoff, roundoff);
  for (double* smallest : {&candidate.smallest_length, &candidate.smallest_camera_length}) {
    *smallest = std::max(*smallest, kSmallestSingleLength);
  }
  for (double* largest : {&candidate.largest_length, &candidate.largest_camera_length}) {
    *largest = std::min(*largest, kLargestSingleLength);
  }
  return candidate;
}

std::optional<double> documented_bound(const Promises& promises, Quantity quantity,
                                       bool has_camera) {
  const auto index = static_cast<std::size_t>(quantity);
  const auto end_to_end = promises.max_error_end_to_end[index];
  return has_camera && end_to_end ? end_to_end : promises.max_error[index];
}

}  // namespace raycheck::properties
