#pragma once

#include "tools/external/pictures/driver_form.h"

namespace raycheck::tools {

/// Five spheres alike, in a cross, ahead; the same behind the eye and between it and the image
/// plane, so that programs see the same which see these. The plane is 1 away, where directions are
/// nearly unit ones and a program that takes d for something else is right. What is ahead has
/// whole numbers, which programs read that read no others. The picture is the same turned and
/// mirrored.
scene::Scene symmetric_scene();

/// Of each cross the sphere in the middle.
scene::Scene middle_spheres();

}  // namespace raycheck::tools
