#pragma once

// A batch as bare arrays. Code that is compiled for one target uses them, since it must not
// instantiate shared templates. Internal to fast/.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "fast/intersect.h"

namespace raycheck::fast {

/// The answer to one ray; `at` is valid only for a hit.
struct Chosen {
  bool hit;
  Hit at;

  std::optional<Hit> if_hit() const { return hit ? std::optional(at) : std::nullopt; }
};

struct RayArrays {
  const double* origin[3];
  const double* direction[3];
};

/// The hit flag of a ray that the kernel cannot decide.
inline constexpr std::uint8_t kOpen = 2;

struct HitArrays {
  std::uint8_t* hit;  ///< 1, 0 or kOpen
  double* parameter;
  double* point[3];
};

/// Expands bit k into byte k.
inline constexpr auto kBytesOfBits = [] {
  std::array<std::uint64_t, 256> bytes{};
  for (std::size_t bits = 0; bits < bytes.size(); ++bits) {
    for (unsigned k = 0; k < 8; ++k) bytes[bits] |= std::uint64_t{bits >> k & 1} << 8 * k;
  }
  return bytes;
}();

/// One array for each number of spheres.
struct SphereArrays {
  const double* centre[3];
  const double* radius;
};

/// The inputs of IntersectMethod::intersect.
struct BatchInput {
  std::size_t count;
  RayArrays rays;
  scene::Sphere sphere;
  scene::HitRule rule;
  /// If set, ray k is compared with sphere k of these. Only decide() uses it.
  const SphereArrays* spheres = nullptr;

  scene::Ray ray(std::size_t k) const {
    const auto& [origin, direction] = rays;
    return {{origin[0][k], origin[1][k], origin[2][k]},
            {direction[0][k], direction[1][k], direction[2][k]}};
  }
  scene::Sphere sphere_of(std::size_t k) const {
    if (spheres == nullptr) return sphere;
    const auto& centre = spheres->centre;
    return {{centre[0][k], centre[1][k], centre[2][k]}, spheres->radius[k]};
  }
};

/// Gives each ray the answer of the method's intersect_one(). Returns false if a ray may be
/// invalid; the answers are then meaningless.
using BatchKernel = bool (*)(const BatchInput&, const HitArrays&);

/// IntersectMethod::intersect with the target's kernel; returns what the kernel was given.
std::pair<BatchInput, HitArrays> intersect_by(BatchKernel kernel, const Rays& rays,
                                              const scene::Sphere& sphere, scene::HitRule rule,
                                              Hits& hits);

}  // namespace raycheck::fast
