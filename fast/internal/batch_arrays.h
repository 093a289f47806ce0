#pragma once

// A batch as bare arrays, for code that is compiled for one target and so must not instantiate what
// others share. Internal to fast/.

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/intersect.h"

namespace raycheck::fast {

struct RayArrays {
  const double* origin[3];
  const double* direction[3];
};

/// In place of a hit: the kernel has no answer.
inline constexpr std::uint8_t kOpen = 2;

struct HitArrays {
  std::uint8_t* hit;  ///< 1, 0 or kOpen
  double* parameter;
  double* point[3];
};

/// Bit k as byte k.
inline constexpr auto kBytesOfBits = [] {
  std::array<std::uint64_t, 256> bytes{};
  for (std::size_t bits = 0; bits < bytes.size(); ++bits) {
    for (unsigned k = 0; k < 8; ++k) bytes[bits] |= std::uint64_t{bits >> k & 1} << 8 * k;
  }
  return bytes;
}();

/// What IntersectMethod::intersect is asked.
struct BatchInput {
  std::size_t count;
  RayArrays rays;
  scene::Sphere sphere;
  scene::Root root;
  scene::Tangent tangent;
};

/// Answers to rays, each as the method's intersect_one() answers it. False where a ray may be no
/// valid one; its answers then mean nothing.
using BatchKernel = bool (*)(const BatchInput&, const HitArrays&);

/// IntersectMethod::intersect by the target's kernel.
void intersect_by(BatchKernel kernel, const Rays& rays, const scene::Sphere& sphere,
                  scene::Root root, scene::Tangent tangent, Hits& hits);

}  // namespace raycheck::fast
