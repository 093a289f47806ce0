#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "scene/plan/plan.h"
#include "scene/scene.h"

namespace raycheck::fast {

/// In place of a sphere: the pixel's ray meets none.
inline constexpr std::int32_t kNothingSeen = -1;

/// What the pixels of a rectangle see, row by row.
struct SeenPixels {
  std::vector<std::int32_t> sphere;  ///< The nearest; the first in the file among equals.
  std::vector<double> parameter;     ///< s; infinite where nothing is seen.

  void resize(std::size_t count) {
    sphere.assign(count, kNothingSeen);
    parameter.assign(count, std::numeric_limits<double>::infinity());
  }
};

/// The side, in pixels, of the square tiles whose rays are made and intersected together.
inline constexpr std::int64_t kVisibleTile = 16;

/// The nearest sphere of every pixel of a rectangle, by any two methods: a tile tests only the
/// spheres whose rectangle in the plan meets it. Ask for a large image band by band.
/// Shape:  a rectangle of N pixels -> N answers; outputs are resized to N.
/// Units:  scene lengths.
/// Domain: a plan of this same scene, a rectangle inside its image, fewer than 2^31 spheres; a
///         method that makes rays from the plan's origin. A ray that is not finite, or whose
///         direction is 0, sees nothing.
/// Error:  what the two methods promise; the plan adds none.
void see(const scene::Scene& scene, const scene::ScenePlan& plan, const PixelRayMethod& rays,
         const IntersectMethod& intersect, const scene::PixelRectangle& pixels, SeenPixels& seen);

}  // namespace raycheck::fast
