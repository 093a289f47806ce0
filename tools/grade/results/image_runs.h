#pragma once

#include <cstddef>
#include <string>

#include "properties/candidate.h"

namespace raycheck::tools {

/// A picture as runs of equal pixels: "12x- 3x0 4x?" are twelve that show none, three of sphere 0,
/// and four of some sphere.
std::string runs_of(const properties::ImageAnswer& image);

/// Reads what runs_of() wrote. Errors: std::logic_error where it is no such text, or of another
/// number of pixels.
properties::ImageAnswer image_of(const std::string& runs, std::size_t pixels);

}  // namespace raycheck::tools
