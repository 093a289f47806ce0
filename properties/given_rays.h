#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "properties/case.h"
#include "properties/tally.h"
#include "scene/conventions.h"
#include "scene/precision.h"

namespace raycheck::properties {

/// A case whose rays were a camera's and are now given, and the pixel of each.
struct GivenRays {
  Case the_case;
  std::vector<scene::Pixel> pixels;
  std::int64_t width = 0;  ///< Of the image.

  /// The pixel's place in place of its ray's.
  Place place(Place of_ray) const;
};

/// The case with the exact rays of its camera under these conventions, correctly rounded to a
/// format and from then on taken exactly, in place of the camera: for who meets rays with spheres
/// and makes none. Rays that are not finite once they are rounded are left out; empty where that
/// leaves none. Domain: a valid scene with a camera; otherwise throws std::invalid_argument.
std::optional<GivenRays> given_rays(const Case& the_case, const scene::Conventions& conventions,
                                    scene::Precision precision = scene::Precision::kDouble);

}  // namespace raycheck::properties
