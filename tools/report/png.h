#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// The bytes of a PNG file, of lines from the top.
/// Domain: width x height pixels, at least one, no side above kMostPictureSide.
/// Error: std::runtime_error with what libpng says.
std::string png_bytes(std::int64_t width, std::int64_t height, std::span<const Colour> pixels);

}  // namespace raycheck::tools
