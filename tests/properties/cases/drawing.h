#pragma once

#include "fast/visible.h"
#include "properties/candidates/fast_candidate.h"
#include "scene/plan/plan.h"

namespace raycheck::properties {

/// direct/cross, which also draws small images like a renderer.
inline Candidate drawing_candidate() {
  Candidate candidate = fast_candidate(fast::kDirectRays, fast::kCross);
  candidate.most_image_pixels = 1 << 14;
  candidate.image = [](const scene::Scene& scene, const scene::Conventions& conventions) {
    const scene::Camera& camera = *scene.camera;
    const auto seen =
        fast::see(scene, scene::plan_scene(scene, conventions, scene::Wanted::kNearest),
                  fast::kDirectRays, fast::kCross, {0, camera.width, 0, camera.height});
    ImageAnswer image(seen.size());
    for (std::size_t k = 0; k < image.size(); ++k) {
      if (seen[k]) image[k] = seen[k]->sphere;
    }
    return image;
  };
  return candidate;
}

}  // namespace raycheck::properties
