#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace raycheck::properties {

/// What a law is asked about: a scene, and the pixels that are looked at when it has a camera (its
/// given rays are all looked at). Where cases come from is no business of a law's.
struct Case {
  scene::Scene scene;
  std::vector<scene::Pixel> pixels;
};

/// How many rays a case looks at.
std::size_t count_rays(const Case& the_case);

/// All pixels of a camera, row by row.
std::vector<scene::Pixel> all_pixels(const scene::Camera& camera);

}  // namespace raycheck::properties
