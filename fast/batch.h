#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/geometry.h"

namespace raycheck::fast {

/// Points or vectors, one array per coordinate.
struct Vectors {
  std::vector<double> x, y, z;

  std::size_t size() const { return x.size(); }
  void resize(std::size_t count) {
    x.resize(count);
    y.resize(count);
    z.resize(count);
  }
  template <class Triple>
  Triple at(std::size_t k) const {
    return {x[k], y[k], z[k]};
  }
  template <class Triple>
  void set(std::size_t k, const Triple& value) {
    x[k] = value.x;
    y[k] = value.y;
    z[k] = value.z;
  }
};

/// Rays origin + s direction.
struct Rays {
  Vectors origin, direction;

  std::size_t size() const { return origin.size(); }
  void resize(std::size_t count) {
    origin.resize(count);
    direction.resize(count);
  }
  scene::Ray at(std::size_t k) const {
    return {origin.at<scene::Point3>(k), direction.at<scene::Vector3>(k)};
  }
  void set(std::size_t k, const scene::Ray& ray) {
    origin.set(k, ray.origin);
    direction.set(k, ray.direction);
  }
};

struct Hit {
  double parameter;     ///< s, in multiples of the ray's direction.
  scene::Point3 point;  ///< Q = L + s D.
};

/// The hits of a batch's rays. parameter[k] and point k are valid only if hit[k] is 1.
struct Hits {
  std::vector<std::uint8_t> hit;
  std::vector<double> parameter;
  Vectors point;

  std::size_t size() const { return hit.size(); }
  void resize(std::size_t count) {
    hit.resize(count);
    parameter.resize(count);
    point.resize(count);
  }
  void set(std::size_t k, bool is_hit, const Hit& at) {
    hit[k] = is_hit ? 1 : 0;
    parameter[k] = at.parameter;
    point.set(k, at.point);
  }
};

}  // namespace raycheck::fast
