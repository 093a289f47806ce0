#pragma once

#include <vector>

#include "properties/candidate.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/report/picture_file.h"

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

/// What a frame around a picture is nearly everywhere; black where it is not of one colour, or the
/// picture shows nothing else.
Colour background_of(const ReadPicture& picture);

/// Whether what lies around the spheres changes from pixel to pixel, as a sky does: nothing tells
/// it from a sphere.
bool is_shaded_around(const ReadPicture& picture);

/// Of the pixels in which a picture or the truth shows a sphere, the share in which both do; 0 of a
/// picture of another size. Domain: a picture without pixels, or as many as the truth has.
double likeness(const ReadPicture& picture, const properties::ImageAnswer& truth);

}  // namespace raycheck::tools
