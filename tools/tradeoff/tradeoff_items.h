#pragma once

// What the stopwatch of `tradeoff` times. Internal to tools/tradeoff/.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "fast/batch.h"
#include "scene/scene.h"

namespace raycheck::tools {

/// Work on the first `count` of some items.
struct Timed {
  std::function<void(std::size_t count)> work;
  std::size_t items = 0;
};

/// Keeps the compiler from leaving out what nobody reads.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

struct Pair {
  scene::Ray ray;
  scene::Sphere sphere;
  scene::Root root;
  scene::Tangent tangent;
};

inline scene::Ray ray_at(const fast::Rays& rays, std::size_t k) {
  return {{rays.origin.x[k], rays.origin.y[k], rays.origin.z[k]},
          {rays.direction.x[k], rays.direction.y[k], rays.direction.z[k]}};
}

/// Rays that meet one sphere.
struct Batch {
  fast::Rays rays;
  scene::Sphere sphere;
  scene::Root root;
  scene::Tangent tangent;
};

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Pixels of one camera.
struct PixelBatch {
  scene::Camera camera;
  scene::Conventions conventions;
  std::vector<scene::Pixel> pixels;
};

}  // namespace raycheck::tools
