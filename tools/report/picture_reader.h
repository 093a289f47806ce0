#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "tools/report/picture_file.h"

namespace raycheck::tools {

struct PictureSize {
  std::int64_t width = 0, height = 0;
};

/// A picture in memory, the top line first.
struct ReadPicture {
  std::int64_t width = 0, height = 0;
  std::vector<Colour> pixels;  ///< Empty where the picture was not to be read further.
  bool has_size(const PictureSize& size) const {
    return width == size.width && height == size.height;
  }
};

/// What was read is not a picture, or too large a one; what() says why.
class PictureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a PPM (P3 or P6, with comments; channels of any maximum are brought to 255) or a PNG.
/// Pictures of more than `most` pixels are errors. `wanted`: of a picture of another size no more
/// is read than its header.
ReadPicture parse_picture(std::string_view bytes, std::int64_t most,
                          const std::optional<PictureSize>& wanted = {});

}  // namespace raycheck::tools
