#pragma once

#include <string>
#include <vector>

#include "properties/mistakes/picture_causes.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// The scene that tells classic mistakes apart.
const scene::Scene& probe();

/// A scene of the rubric of the seventh lecture, and most of them: the first is square and
/// symmetric, of an eye at the origin.
scene::Scene rubric_scene(const std::string& name);
std::vector<scene::Scene> rubric_scenes();

/// The pictures of a program with a fault.
std::vector<ShownPicture> shown_with(const Fault& fault, const std::vector<scene::Scene>& scenes);

}  // namespace raycheck::properties
