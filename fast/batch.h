#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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
};

/// Rays origin + s direction.
struct Rays {
  Vectors origin, direction;

  std::size_t size() const { return origin.size(); }
  void resize(std::size_t count) {
    origin.resize(count);
    direction.resize(count);
  }
};

/// What each ray of a batch hits; parameter and point are valid only where hit is 1.
struct Hits {
  std::vector<std::uint8_t> hit;
  std::vector<double> parameter;  ///< s, in multiples of the ray's direction.
  Vectors point;                  ///< Q = L + s D.

  std::size_t size() const { return hit.size(); }
  void resize(std::size_t count) {
    hit.resize(count);
    parameter.resize(count);
    point.resize(count);
  }
};

}  // namespace raycheck::fast
