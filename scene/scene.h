#pragma once

#include <optional>
#include <vector>

#include "scene/camera.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::scene {

/// A camera or given rays (exactly one of the two), the spheres that the rays may meet, and the
/// conventions under which answers are judged.
struct Scene {
  std::optional<Camera> camera;
  std::vector<Ray> rays;
  std::vector<Sphere> spheres;
  Conventions conventions;
  bool operator==(const Scene&) const = default;
};

}  // namespace raycheck::scene
