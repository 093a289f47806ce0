#pragma once

#include <vector>

#include "properties/candidate.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// Five equal spheres ahead, in a cross; the same behind the eye and between the eye and the image
/// plane, so that programs that wrongly draw those show the same picture. The plane is at distance
/// 1, where directions are nearly unit vectors and programs that misread d are right. The spheres
/// ahead have whole numbers, which every program reads. Rotated by 90 degrees or mirrored, the
/// picture is the same.
scene::Scene symmetric_scene();

/// The same scene, ten times as large; all its numbers are integers.
scene::Scene whole_scene();

/// A few ordinary scenes, with fractions and spheres behind the eye.
std::vector<scene::Scene> ordinary_scenes();

/// The middle sphere of each cross.
scene::Scene middle_spheres();

/// The background colour: that of nearly all pixels on a picture's border. Black if no colour is
/// that frequent, or if the whole picture has one colour.
Colour background_of(const ReadPicture& picture);

/// Whether the background is shaded, like a sky: then spheres cannot be told from it.
bool is_shaded_around(const ReadPicture& picture);

/// The likeness of a picture to the truth: pixels where both show a sphere, divided by pixels where
/// at least one does. 0 for a picture without pixels (of another size). Domain: a picture without
/// pixels, or with as many as the truth.
double likeness(const ReadPicture& picture, const properties::ImageAnswer& truth);

}  // namespace raycheck::tools
