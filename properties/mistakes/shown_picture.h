#pragma once

#include <optional>

#include "properties/candidate.h"

namespace raycheck::properties {

/// The exact nearest sphere of each pixel. Domain: a scene with a camera.
ImageAnswer exact_image(const Scene& scene, const Conventions& conventions);

/// A renderer's picture of a scene with a camera, under the conventions of that scene: one answer
/// for every pixel, which may be kSomeSphere or kUnclear.
struct ShownPicture {
  Scene scene;
  ImageAnswer image;
  /// Whether the picture has width and height exchanged; then `image` is empty.
  bool sides_exchanged = false;
  DepthAnswer depths = {};         ///< The numbers of a depth picture; empty for others.
  Depth depth = Depth::kDistance;  ///< What they are declared to be.
};

/// A candidate's picture of a scene, under the conventions by which it is judged; empty if it
/// fails.
std::optional<ShownPicture> shown_picture(Scene scene, const Candidate& candidate);

}  // namespace raycheck::properties
