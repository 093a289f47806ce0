#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "reference/enclosure.h"
#include "scene/scene.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// A position or a direction in a drawing.
/// Units: (p - origin) * 2^exponent of its frame; directions are unit vectors.
using Drawn = std::array<double, 3>;

/// Named places. figure_parts.cpp lists the parts that are drawn between, at and beside them.
using DrawnPlaces = std::vector<std::pair<std::string, Drawn>>;

/// The origin and the scale of drawn coordinates. The scale is a power of two. It makes the
/// distance of the camera's image plane about 1 or, if there is no camera, the distance of the
/// first sphere from the first ray's origin.
class DrawnFrame {
 public:
  explicit DrawnFrame(const scene::Scene& scene);

  const scene::Point3& origin() const { return origin_; }
  int exponent() const { return exponent_; }

  /// Exact up to one rounding; infinite if the scaled coordinate leaves the double range.
  Drawn point(const scene::Point3& point) const;
  double length(double length) const;
  /// A point that is given by enclosures of any precision; off by at most 2^-40 of its distance
  /// from the origin.
  Drawn point(const std::function<reference::Enclosure3(int bits)>& enclose) const;

 private:
  scene::Point3 origin_;
  int exponent_ = 0;
};

/// The direction of `v` with a length of about 1, whatever the length of `v`.
Drawn unit(const scene::Vector3& v);
inline Drawn unit(const scene::UnitVector3& v) { return {v.x, v.y, v.z}; }

inline Drawn operator+(const Drawn& a, const Drawn& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Drawn operator-(const Drawn& a, const Drawn& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Drawn operator*(double k, const Drawn& a) { return {k * a[0], k * a[1], k * a[2]}; }
inline double dot_product(const Drawn& a, const Drawn& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// |a|, computed without overflow or underflow.
inline double length_of(const Drawn& a) { return std::hypot(a[0], a[1], a[2]); }
inline bool is_finite(const Drawn& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// A drawn number or place; null if it is not finite.
inline Json drawn(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
inline Json drawn(const Drawn& place) { return is_finite(place) ? Json(place) : Json(nullptr); }
/// The finite places by their names.
Json places_json(const DrawnPlaces& places);

}  // namespace raycheck::tools
