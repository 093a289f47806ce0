#ifndef RAYCHECK_TOOLS_REPORT_PICTURE_READER_H_
#define RAYCHECK_TOOLS_REPORT_PICTURE_READER_H_

#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// A picture in memory, the top line first.
struct ReadPicture {
  std::int64_t width = 0, height = 0;
  std::vector<Colour> pixels;
};

/// What was read is not a picture, or too large a one; what() says why.
class PictureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a PPM (P3 or P6, with comments; channels of any maximum are brought to 255) or a PNG.
/// Pictures of more than `most` pixels are errors.
ReadPicture parse_picture(std::string_view bytes, std::int64_t most);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_REPORT_PICTURE_READER_H_
