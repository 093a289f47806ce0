#pragma once

#include <vector>

#include "tools/external/pictures/driver_form.h"

namespace raycheck::tools {

/// Five spheres alike, in a cross, ahead; the same behind the eye and between it and the image
/// plane, so that programs see the same which see these. The plane is 1 away, where directions are
/// nearly unit ones and a program that takes d for something else is right. What is ahead has
/// whole numbers, which programs read that read no others. The picture is the same turned and
/// mirrored.
scene::Scene symmetric_scene();

/// The same ten times as large, all its numbers whole.
scene::Scene whole_scene();

/// A few scenes as they are judged, with fractions, and spheres behind the eye.
std::vector<scene::Scene> ordinary_scenes();

/// Of each cross the sphere in the middle.
scene::Scene middle_spheres();

}  // namespace raycheck::tools
