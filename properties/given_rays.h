#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "properties/case.h"
#include "properties/tally.h"
#include "scene/conventions.h"
#include "scene/precision.h"

namespace raycheck::properties {

/// A case with a camera's rays as given rays, and the pixel of each.
struct GivenRays {
  Case the_case;
  std::vector<scene::Pixel> pixels;
  std::int64_t width = 0;  ///< Of the image.

  /// Replaces the ray in a place by its pixel.
  Place place(Place of_ray) const;
};

/// The case with the exact rays of its camera under these conventions, correctly rounded to a
/// format and then taken as exact, in place of the camera: for candidates that intersect rays but
/// make none. Rays that round to non-finite ones are left out; empty if none is left. Domain: a
/// valid scene with a camera; otherwise throws std::invalid_argument.
std::optional<GivenRays> given_rays(const Case& the_case, const scene::Conventions& conventions,
                                    scene::Precision precision = scene::Precision::kDouble);

}  // namespace raycheck::properties
