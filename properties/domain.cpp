#include "properties/domain.h"

#include <algorithm>
#include <cmath>

namespace raycheck::properties {
namespace {

template <class Triple>
double length(const Triple& v) {
  return std::hypot(v.x, v.y, v.z);
}

}  // namespace

Domain judged_in(scene::Precision precision, Domain domain) {
  if (precision == scene::Precision::kDouble) return domain;
  const auto cut = [](double& smallest, double& largest) {
    smallest = std::max(smallest, kSmallestSingleLength);
    largest = std::min(largest, kLargestSingleLength);
  };
  cut(domain.smallest_length, domain.largest_length);
  cut(domain.smallest_camera_length, domain.largest_camera_length);
  return domain;
}

bool lengths_are_within(const scene::Scene& scene, double smallest, double largest) {
  const auto within = [&](double size) {
    return size == 0 || (std::abs(size) >= smallest && std::abs(size) <= largest);
  };
  bool inside = true;
  const auto require = [&](double size) { inside = inside && within(size); };
  const auto require_distance_of_points = [&](const scene::Point3& from) {
    for (const scene::Sphere& sphere : scene.spheres) {
      if (sphere.radius == 0) require(length(sphere.centre - from));
    }
  };
  if (scene.camera) {
    const scene::Camera& camera = *scene.camera;
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
  for (const scene::Ray& ray : scene.rays) {
    require(length(ray.direction));
    inside = inside && length(ray.origin) <= largest;
    require_distance_of_points(ray.origin);
  }
  for (const scene::Sphere& sphere : scene.spheres) {
    require(sphere.radius);
    inside = inside && length(sphere.centre) <= largest;
  }
  return inside;
}

bool is_inside_domain(const Domain& domain, const scene::Scene& scene) {
  return lengths_are_within(scene, domain.smallest_length, domain.largest_length) &&
         (!scene.camera ||
          lengths_are_within(scene, domain.smallest_camera_length, domain.largest_camera_length));
}

}  // namespace raycheck::properties
