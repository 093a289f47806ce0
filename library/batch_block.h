#pragma once

// Blocks of answers of raycheck/batch.h: where their numbers are, and how they are decided.

#include <array>
#include <cstring>
#include <memory>

#include "fast/decide.h"
#include "library/batch_arrays.h"

namespace raycheck::library {

using Numbers = std::array<double, kBatchBlock>;

/// The numbers of one block, where arrays cannot be used in place.
struct Work {
  std::array<Numbers, 10> given;
  std::array<Numbers, 8> found;
  std::array<std::uint8_t, kBatchBlock> codes, bytes;
  std::array<std::int32_t, kBatchBlock> sphere, ties;
};
inline Work& work_of_thread() {
  static thread_local const auto work = std::make_unique<Work>();
  return *work;
}

/// A block of answers, and the inputs of decide() for it.
struct Block {
  std::size_t first, count;
  fast::BatchInput input;
  fast::SphereArrays spheres;
  fast::HitArrays to;
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;

  /// The answers go to the arrays if these are doubles without gaps.
  Block(const Questions& asked, std::size_t answer, std::size_t size, const Target& s,
        const Target3& point, Work& work)
      : first(answer), count(size), input(), spheres(), to() {
    to = {work.codes.data(),
          s.block(answer, work.found[0].data()),
          {point.x.block(answer, work.found[1].data()), point.y.block(answer, work.found[2].data()),
           point.z.block(answer, work.found[3].data())}};
    input.rule = {asked.conventions().root, scene::Tangent::kHit};
    input.count = count;
    if (!asked.is_usual() || asked.spheres() == 0) {  // bound_errors() adds nothing of the inputs
      const double* const zeros = (work.given[0] = Numbers()).data();
      input.rays = {{zeros, zeros, zeros}, {zeros, zeros, zeros}};
      return;
    }
    const auto arrays = [&](const Column3& of, std::size_t from, std::size_t k, auto& in) {
      in[0] = of.x.block(from, count, work.given[k].data());
      in[1] = of.y.block(from, count, work.given[k + 1].data());
      in[2] = of.z.block(from, count, work.given[k + 2].data());
    };
    const std::size_t ray = asked.ray_of(first);
    arrays(asked.origin, ray, 0, input.rays.origin);
    arrays(asked.direction, ray, 3, input.rays.direction);
    if (asked.each_with_every() || asked.spheres() == 1) {
      input.sphere = asked.sphere(asked.sphere_of(first));
    } else {
      arrays(asked.centre, first, 6, spheres.centre);
      spheres.radius = asked.radius.block(first, count, work.given[9].data());
      input.spheres = &spheres;
    }
  }

  void set(std::size_t k, std::uint8_t code, double s, const scene::Point3& at) const {
    to.hit[k] = code;
    to.parameter[k] = s;
    to.point[0][k] = at.x;
    to.point[1][k] = at.y;
    to.point[2][k] = at.z;
  }
  void set(std::size_t k, std::uint8_t code, double all) const {
    set(k, code, all, {all, all, all});
  }
};

/// The answer of the exact ray: s and Q are correctly rounded.
inline void put_exact(const Block& block, std::size_t k, const reference::ExactRay& ray,
                      const scene::Sphere& sphere, const reference::Intersection& at) {
  if (at.hit_class == reference::HitClass::kMiss) return block.set(k, fast::kMiss, kInvalidNumber);
  const bool is_tangent = at.hit_class == reference::HitClass::kTangent;
  const bool is_larger = at.root == reference::WhichRoot::kLarger;
  block.set(k,
            fast::kHit | (is_tangent ? fast::kTangentRay : 0) | (is_larger ? fast::kLargerRoot : 0),
            ray.rounded_parameter(sphere, at), ray.rounded_point(sphere, at));
}

inline void decide_block(const Questions& asked, const Block& block) {
  if (asked.is_usual()) {
    fast::decide(block.input, block.to);
  } else {
    for (std::size_t k = 0; k < block.count; ++k) {
      const auto ray = asked.exact(asked.ray_of(block.first + k));
      const scene::Sphere sphere = asked.sphere(asked.sphere_of(block.first + k));
      if (ray && asked.is_valid_sphere(asked.sphere_of(block.first + k))) {
        put_exact(block, k, *ray, sphere, ray->intersect(sphere, asked.conventions()));
      } else {
        block.to.hit[k] = fast::kOpen;
      }
    }
  }
  if (std::memchr(block.to.hit, fast::kOpen, block.count) == nullptr) return;
  for (std::size_t k = 0; k < block.count; ++k) {
    if (block.to.hit[k] != fast::kOpen) continue;
    block.set(k, fast::kOpen, kInvalidNumber);
    asked.note_ray(asked.ray_of(block.first + k));
    asked.note_sphere(asked.sphere_of(block.first + k));
  }
}

}  // namespace raycheck::library
