#include "tools/view/figure/drawn_frame.h"

#include <algorithm>
#include <optional>

namespace raycheck::tools {
namespace {

using reference::Enclosure;
using reference::Enclosure3;

/// (a - b) 2^exponent, rounded once.
double scaled_difference(double a, double b, int exponent) {
  const double difference = a - b;
  if (std::isfinite(difference)) return std::ldexp(difference, exponent);
  return std::ldexp(a / 2 - b / 2, exponent + 1);  // halves of such large numbers are exact
}

/// The middle of enclosures; empty if they are wider than the tolerance of a drawing.
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

}  // namespace

Drawn unit(const scene::Vector3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const int exponent = -std::ilogb(largest);
  const Drawn near_one = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent),
                          std::ldexp(v.z, exponent)};
  const double length = std::hypot(near_one[0], near_one[1], near_one[2]);
  return {near_one[0] / length, near_one[1] / length, near_one[2] / length};
}

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
    // Half of the exponent is applied twice, because 2^exponent may not be a double.
    const Enclosure half(std::ldexp(1.0, exponent_ / 2), bits);
    const Enclosure rest(std::ldexp(1.0, exponent_ - exponent_ / 2), bits);
    const auto moved = [&](const Enclosure& coordinate, double from) {
      return (coordinate - Enclosure(from, bits)) * half * rest;
    };
    const Enclosure3 value = enclose(bits);
    const Enclosure3 relative = {moved(value.x, origin_.x), moved(value.y, origin_.y),
                                 moved(value.z, origin_.z)};
    if (const auto known = middle(relative)) return *known;
    // The point is nearer to the origin than any double.
    if (bits >= kMostBits) return {0, 0, 0};
  }
}

Json places_json(const DrawnPlaces& places) {
  Json json = Json::object();
  for (const auto& [name, place] : places) {
    if (is_finite(place)) json[name] = place;
  }
  return json;
}

}  // namespace raycheck::tools
