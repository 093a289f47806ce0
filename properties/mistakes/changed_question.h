#pragma once

// Mistakes that give the right answer to a different question, with candidates that make them.

#include <string>

#include "properties/mistakes/mistakes.h"

namespace raycheck::properties {

/// Takes another camera, and other spheres.
Mistake scene_mistake(std::string sentence, Step step, const ChangeCamera& camera,
                      const ChangeSphere& sphere);
Mistake camera_mistake(std::string sentence, const ChangeCamera& change,
                       Step step = Step::kPixelPoint);
Mistake convention_mistake(std::string sentence, const ChangeConventions& change, Step step);
Mistake pixel_mistake(std::string sentence, const ChangePixel& change);

}  // namespace raycheck::properties
