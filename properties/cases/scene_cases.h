#pragma once

#include <cstdint>
#include <optional>

#include "properties/case.h"

namespace raycheck::properties {

/// The rays of a scene as cases for the laws. `at_most` limits the number of rays of a camera; they
/// are then spread evenly over the image.
class SceneCases {
 public:
  SceneCases(Scene scene, std::optional<std::uint64_t> at_most);

  const Scene& scene() const { return scene_; }
  std::uint64_t rays_in_scene() const;
  std::uint64_t rays_judged() const { return judged_; }
  /// A case with the rays [first, end) of those judged.
  Case from(std::uint64_t first, std::uint64_t end) const;

 private:
  Scene scene_;
  std::uint64_t judged_;
};

}  // namespace raycheck::properties
