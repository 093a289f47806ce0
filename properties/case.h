#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace raycheck::properties {

/// What a law is applied to: a scene and, if it has a camera, the pixels to look at (given rays are
/// all looked at). A law does not know where its cases come from.
struct Case {
  scene::Scene scene;
  std::vector<scene::Pixel> pixels;
};

/// How many rays a case looks at.
std::size_t count_rays(const Case& the_case);

/// All pixels of a camera, row by row.
std::vector<scene::Pixel> all_pixels(const scene::Camera& camera);

}  // namespace raycheck::properties
