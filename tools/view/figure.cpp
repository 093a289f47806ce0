#include "tools/view/figure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact_camera.h"
#include "scene/number.h"
#include "tools/image/image_paint.h"

namespace raycheck::tools {
namespace {

using reference::Enclosure;
using reference::Enclosure3;

/// (a - b) 2^exponent, rounded once.
double scaled_difference(double a, double b, int exponent) {
  const double difference = a - b;
  if (std::isfinite(difference)) return std::ldexp(difference, exponent);
  return std::ldexp(a / 2 - b / 2, exponent + 1);  // of numbers so large that halves are exact
}

Drawn unit(const scene::UnitVector3& v) { return {v.x, v.y, v.z}; }

/// A direction of length about 1, whatever the length of `v` is.
Drawn unit(const scene::Vector3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const int exponent = -std::ilogb(largest);
  const Drawn near_one = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent),
                          std::ldexp(v.z, exponent)};
  const double length = std::hypot(near_one[0], near_one[1], near_one[2]);
  return {near_one[0] / length, near_one[1] / length, near_one[2] / length};
}

/// The middle of enclosures; empty where they are wider than what is drawn may be off by.
std::optional<Drawn> middle(const Enclosure3& value) {
  constexpr double kRelativeWidth = 0x1p-40;
  double largest = 0, widest = 0;
  const auto middle_of = [&](const Enclosure& coordinate) {
    const double low = coordinate.lower(), high = coordinate.upper();
    widest = std::max(widest, high - low);
    largest = std::max({largest, std::abs(low), std::abs(high)});
    return low / 2 + high / 2;
  };
  const Drawn result = {middle_of(value.x), middle_of(value.y), middle_of(value.z)};
  if (widest > kRelativeWidth * largest) return std::nullopt;
  return result;
}

DrawnCamera drawn_camera(const scene::Scene& scene, const DrawnFrame& frame) {
  const scene::Camera& camera = *scene.camera;
  const auto axes = reference::ExactCamera(camera, scene.conventions).rounded_frame();
  DrawnCamera drawn;
  drawn.U = unit(axes.U);
  drawn.V = unit(axes.V);
  drawn.W = unit(axes.W);
  drawn.look_at = frame.point(camera.look_at);
  drawn.up = unit(camera.up);
  drawn.near = frame.length(camera.near);
  drawn.left = frame.length(camera.left);
  drawn.right = frame.length(camera.right);
  drawn.bottom = frame.length(camera.bottom);
  drawn.top = frame.length(camera.top);
  if (camera.far) drawn.far = frame.length(*camera.far);
  return drawn;
}

/// Whether one of the two roots may be the answer under conventions.
bool may_count(const reference::ExactRay& ray, const scene::Sphere& sphere,
               const reference::Intersection& at, const scene::Conventions& conventions) {
  const bool is_asked =
      conventions.root == scene::Root::kNearest || at.root == reference::WhichRoot::kSmaller;
  return is_asked && ray.counts(sphere, at, conventions.valid) == reference::RootCounts::kYes;
}

/// How the whole line meets a sphere, behind the ray's origin too.
reference::HitClass class_of_line(const reference::ExactRay& ray, const scene::Sphere& sphere) {
  scene::Conventions anywhere;
  anywhere.valid.t_min = std::numeric_limits<double>::lowest();
  return ray.intersect(sphere, anywhere).hit_class;
}

/// L + v D
Enclosure3 foot(const reference::ExactRay& ray, const scene::Sphere& sphere, int bits) {
  const auto enclosed = ray.enclose(bits);
  const Enclosure3 origin = enclosed.origin(), direction = enclosed.direction();
  const Enclosure v = enclosed.axial_distance(sphere);
  return {origin.x + v * direction.x, origin.y + v * direction.y, origin.z + v * direction.z};
}

}  // namespace

DrawnFrame::DrawnFrame(const scene::Scene& scene) {
  double size = 1;
  if (scene.camera) {
    const scene::Camera& camera = *scene.camera;
    origin_ = camera.eye;
    size = 0;
    for (const double length :
         {camera.near, camera.left, camera.right, camera.bottom, camera.top}) {
      size = std::max(size, std::abs(length));
    }
  } else if (!scene.rays.empty()) {
    origin_ = scene.rays.front().origin;
    if (!scene.spheres.empty()) {
      const scene::Sphere& sphere = scene.spheres.front();
      size = sphere.radius;
      for (const double way :
           {sphere.centre.x / 2 - origin_.x / 2, sphere.centre.y / 2 - origin_.y / 2,
            sphere.centre.z / 2 - origin_.z / 2}) {
        size = std::max(size, std::abs(way));
      }
    }
  }
  exponent_ = size > 0 ? -std::ilogb(size) : 0;
}

Drawn DrawnFrame::point(const scene::Point3& point) const {
  return {scaled_difference(point.x, origin_.x, exponent_),
          scaled_difference(point.y, origin_.y, exponent_),
          scaled_difference(point.z, origin_.z, exponent_)};
}

double DrawnFrame::length(double length) const { return std::ldexp(length, exponent_); }

Drawn DrawnFrame::point(const std::function<Enclosure3(int bits)>& enclose) const {
  constexpr int kFewestBits = 128, kMostBits = 1 << 14;
  for (int bits = kFewestBits;; bits *= 2) {
    // Twice, for 2^exponent may be no double.
    const Enclosure half(std::ldexp(1.0, exponent_ / 2), bits);
    const Enclosure rest(std::ldexp(1.0, exponent_ - exponent_ / 2), bits);
    const auto moved = [&](const Enclosure& coordinate, double from) {
      return (coordinate - Enclosure(from, bits)) * half * rest;
    };
    const Enclosure3 value = enclose(bits);
    const Enclosure3 relative = {moved(value.x, origin_.x), moved(value.y, origin_.y),
                                 moved(value.z, origin_.z)};
    if (const auto known = middle(relative)) return *known;
    // Nearer to the origin than any double can say.
    if (bits >= kMostBits) return {0, 0, 0};
  }
}

Figure figure_of(const scene::Scene& scene, std::size_t most_spheres) {
  const DrawnFrame frame(scene);
  Figure figure;
  figure.origin = frame.origin();
  figure.scale_exponent = frame.exponent();
  if (scene.camera) figure.camera = drawn_camera(scene, frame);
  for (const scene::Ray& ray : scene.rays) {
    figure.rays.push_back({frame.point(ray.origin), unit(ray.direction)});
  }
  const std::size_t drawn = std::min(scene.spheres.size(), most_spheres);
  figure.spheres_left_out = scene.spheres.size() - drawn;
  for (std::size_t k = 0; k < drawn; ++k) {
    const scene::Sphere& sphere = scene.spheres[k];
    figure.spheres.push_back(
        {frame.point(sphere.centre), frame.length(sphere.radius), sphere_colour(k),
         fmt::format("sphere {}: C = ({}, {}, {}), r = {}", k, scene::shortest(sphere.centre.x),
                     scene::shortest(sphere.centre.y), scene::shortest(sphere.centre.z),
                     scene::shortest(sphere.radius))});
  }
  return figure;
}

PanelDrawing drawing_of(const DrawnFrame& frame, const reference::ExactRay& ray,
                        const scene::Sphere* sphere, const scene::Conventions& conventions) {
  PanelDrawing drawing;
  drawing.origin = frame.point([&](int bits) { return ray.enclose(bits).origin(); });
  if (ray.source().camera) {
    drawing.pixel = frame.point([&](int bits) { return ray.enclose(bits).pixel_point(); });
  }
  drawing.direction = unit(ray.rounded_direction());
  if (sphere == nullptr) return drawing;
  drawing.foot = frame.point([&](int bits) { return foot(ray, *sphere, bits); });
  const auto chosen = ray.intersect(*sphere, conventions);
  const auto line = class_of_line(ray, *sphere);
  if (line == reference::HitClass::kMiss) return drawing;
  for (const auto which : {reference::WhichRoot::kSmaller, reference::WhichRoot::kLarger}) {
    const bool smaller = which == reference::WhichRoot::kSmaller;
    if (line == reference::HitClass::kTangent && !smaller) break;
    const reference::Intersection at = {line, which};
    DrawnRoot root;
    root.smaller = smaller;
    root.parameter = ray.rounded_parameter(*sphere, at);
    root.point = frame.point([&](int bits) { return ray.enclose(bits).point(*sphere, at); });
    root.counts = may_count(ray, *sphere, at, conventions);
    root.is_chosen = chosen.hit_class != reference::HitClass::kMiss &&
                     (chosen.root == which || line == reference::HitClass::kTangent);
    drawing.roots.push_back(root);
  }
  return drawing;
}

}  // namespace raycheck::tools
