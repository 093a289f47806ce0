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

namespace {

template <class Conventions>
Conventions put_over(const DeclaredConventions& declared, Conventions conventions) {
  const auto put = [](const auto& ours, auto& theirs) {
    if (ours) theirs = *ours;
  };
  put(declared.rows, conventions.rows);
  put(declared.samples, conventions.samples);
  put(declared.origin, conventions.origin);
  put(declared.root, conventions.root);
  put(declared.tangent, conventions.tangent);
  put(declared.valid, conventions.valid);
  return conventions;
}

/// Numbers with 11 bits more than doubles, and with exponents so wide that nothing here overflows.
struct Wide {
  template <class Triple>
  explicit Wide(const Triple& v) : x(v.x), y(v.y), z(v.z) {}
  Wide(long double its_x, long double its_y, long double its_z) : x(its_x), y(its_y), z(its_z) {}
  Wide operator-(const Wide& other) const { return {x - other.x, y - other.y, z - other.z}; }
  long double dot(const Wide& other) const { return x * other.x + y * other.y + z * other.z; }
  long double x, y, z;
};

}  // namespace

HitAnswer completed(const HitAnswer& hit, Returns returns, const scene::Ray& ray,
                    const scene::Sphere& sphere) {
  const Wide origin(ray.origin), direction(ray.direction);
  const long double a = direction.dot(direction);
  const auto projection = [&](const scene::Point3& point) {
    return (Wide(point) - origin).dot(direction) / a;
  };
  long double s = hit.parameter;
  switch (returns) {
    case Returns::kHit:
      return hit;
    case Returns::kParameter:
      break;
    case Returns::kPoint:
      return {static_cast<double>(projection(hit.point)), hit.point};
    case Returns::kDistance:
      s /= std::sqrt(a);
      break;
    case Returns::kSquaredDistance:
      s = std::sqrt(s / a);
      break;
    case Returns::kClass:
      s = std::max(0.0L, projection(sphere.centre));
      break;
  }
  const auto along = [s](double from, double by) { return static_cast<double>(from + s * by); };
  return {static_cast<double>(s),
          {along(ray.origin.x, ray.direction.x), along(ray.origin.y, ray.direction.y),
           along(ray.origin.z, ray.direction.z)}};
}

Functions completed(Functions functions, Returns returns) {
  if (returns == Returns::kHit || !functions.intersect) return functions;
  functions.intersect = [intersect = std::move(functions.intersect), returns](
                            Functions::Rays rays, Functions::Spheres spheres,
                            const scene::Conventions& conventions) {
    std::vector<SphereHits> all = intersect(rays, spheres, conventions);
    for (std::size_t sphere = 0; sphere < std::min(all.size(), spheres.size()); ++sphere) {
      for (RayHit& hit : all[sphere]) {
        if (hit.ray >= rays.size()) continue;  // Answers reports it
        hit.hit = completed(hit.hit, returns, rays[hit.ray], spheres[sphere]);
      }
    }
    return all;
  };
  return functions;
}

scene::Conventions DeclaredConventions::over(scene::Conventions conventions) const {
  return put_over(*this, conventions);
}

DeclaredConventions DeclaredConventions::over(DeclaredConventions others) const {
  return put_over(*this, others);
}

bool is_problem(const Case& the_case, const DeclaredConventions& declared) {
  if (!declared.samples && !declared.valid) return true;
  scene::Scene scene = the_case.scene;
  scene.conventions = declared.over(scene.conventions);
  return scene::defects(scene).empty();
}

Candidate judged_in(scene::Precision precision, Candidate candidate) {
  if (precision == scene::Precision::kDouble) return candidate;
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
  static_cast<Domain&>(candidate) = judged_in(precision, static_cast<const Domain&>(candidate));
  return candidate;
}

std::optional<double> documented_bound(const Promises& promises, Quantity quantity,
                                       bool has_camera) {
  const auto index = static_cast<std::size_t>(quantity);
  const auto end_to_end = promises.max_error_end_to_end[index];
  return has_camera && end_to_end ? end_to_end : promises.max_error[index];
}

}  // namespace raycheck::properties
