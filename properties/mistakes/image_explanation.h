#ifndef RAYCHECK_PROPERTIES_MISTAKES_IMAGE_EXPLANATION_H_
#define RAYCHECK_PROPERTIES_MISTAKES_IMAGE_EXPLANATION_H_

#include <vector>

#include "properties/candidate.h"
#include "properties/mistakes/explanation.h"

namespace raycheck::properties {

/// What each pixel sees, exactly. Domain: a scene with a camera.
ImageAnswer exact_image(const scene::Scene& scene, const scene::Conventions& conventions);

/// A black picture, which many mistakes make.
bool shows_nothing(const ImageAnswer& image);

/// What explains at least kExplainedShare of an image's errors; of several the best, all where they
/// explain as many. The image as another camera, other conventions or another order of pixels make
/// it is worked out exactly; as a wrong formula makes it, in doubles, and one is named only where
/// it explains more than any of these. An image that shows nothing does not tell why: none.
/// Domain: a scene with a camera; an answer for every pixel, under these conventions.
std::vector<Explanation> explanations(const scene::Scene& scene,
                                      const scene::Conventions& conventions,
                                      const ImageAnswer& image);

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_MISTAKES_IMAGE_EXPLANATION_H_
