#pragma once

#include <vector>

#include "properties/candidate.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// Five equal spheres ahead, in a cross; the same behind the eye and between it and the image
/// plane, so that programs that see these show the same picture. The plane is at distance 1, where
/// directions are nearly unit vectors and programs that misread d are right. The spheres ahead have
/// whole numbers, which every program reads. The picture is the same turned and mirrored.
scene::Scene symmetric_scene();

/// The same ten times as large, all its numbers whole.
scene::Scene whole_scene();

/// A few scenes as they are judged, with fractions, and spheres behind the eye.
std::vector<scene::Scene> ordinary_scenes();

/// The middle sphere of each cross.
scene::Scene middle_spheres();

/// The colour of nearly all of a picture's frame; black if it has no such colour, or the picture
/// shows nothing else.
Colour background_of(const ReadPicture& picture);

/// Whether the background changes from pixel to pixel, as a sky does: then it cannot be told from a
/// sphere.
bool is_shaded_around(const ReadPicture& picture);

/// Of the pixels in which a picture or the truth shows a sphere, the share in which both do; 0 of a
/// picture of another size. Domain: a picture without pixels, or as many as the truth has.
double likeness(const ReadPicture& picture, const properties::ImageAnswer& truth);

}  // namespace raycheck::tools
