#pragma once

#include <vector>

#include "properties/candidate.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// A scene whose picture most mistakes do not change. Five equal spheres are ahead, in a cross;
/// five more are behind the eye and five between the eye and the image plane, and programs that
/// wrongly draw these show the same picture. The plane is at distance 1, where directions are
/// nearly unit vectors, and programs that misread the distance of the plane are right. The numbers
/// of the spheres ahead are integers, which every program reads. The picture is the same if it is
/// rotated by 90 degrees or mirrored.
scene::Scene symmetric_scene();

/// The symmetric scene, ten times as large; all its numbers are integers.
scene::Scene whole_scene();

/// A few ordinary scenes, with fractions and spheres behind the eye.
std::vector<scene::Scene> ordinary_scenes();

/// The middle sphere of each cross.
scene::Scene middle_spheres();

/// The background colour: the colour of nearly all pixels on a picture's border. Black if no colour
/// is so frequent, or if the whole picture has one colour.
Colour background_of(const ReadPicture& picture);

/// Whether the background is shaded, like a sky, so that it cannot be distinguished from spheres.
bool is_shaded_around(const ReadPicture& picture);

/// The likeness of a picture to the truth: the number of pixels where both show a sphere, divided
/// by the number where at least one does. 0 for a picture without pixels (because its size is
/// wrong). Domain: a picture without pixels, or with as many as the truth.
double likeness(const ReadPicture& picture, const properties::ImageAnswer& truth);

}  // namespace raycheck::tools
