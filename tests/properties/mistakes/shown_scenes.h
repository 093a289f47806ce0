#pragma once

#include <vector>

#include "properties/mistakes/picture_causes.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// The scene that tells classic mistakes apart.
const scene::Scene& probe();

/// Scenes as a rubric for pictures has them: square and asymmetric, not square and symmetric, one
/// sphere, many, spheres before the image plane and behind the eye, around it, small and near.
std::vector<scene::Scene> rubric_scenes();

/// The pictures of a program with a fault.
std::vector<ShownPicture> shown_with(const Fault& fault, const std::vector<scene::Scene>& scenes);

}  // namespace raycheck::properties
