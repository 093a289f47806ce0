#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tools/report/output_file.h"

namespace raycheck::tools {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
};
static_assert(sizeof(Colour) == 3, "pixels are written as laid out in memory");

/// A picture has at most this many pixels across, and down: libpng's limit.
inline constexpr std::int64_t kMostPictureSide = 1'000'000;

class PngEncoder;

/// A picture file that an option names, written line by line from the top: PNG or PPM (P6), by its
/// extension. Like an OutputFile, it appears completely or not at all.
/// Error: functions throw std::runtime_error if the picture cannot be written.
class PictureFile {
 public:
  /// Throws std::invalid_argument naming the option if it has another extension, and what
  /// OutputFile throws.
  PictureFile(std::string option, std::string path);
  ~PictureFile();

  const std::string& path() const { return path_; }
  /// Domain: no side above kMostPictureSide.
  void start(std::int64_t width, std::int64_t height);
  /// Adds the next lines. All lines together must be the picture.
  void add(std::span<const Colour> lines);
  void place();

 private:
  std::string path_;
  OutputFile file_;
  std::unique_ptr<PngEncoder> png_;  ///< Null for a PPM.
  std::size_t width_ = 0;
};

/// The bytes of a PNG file. The first line of pixels is the top line.
/// Domain: width x height pixels, at least one, no side above kMostPictureSide.
/// Error: std::runtime_error with what libpng says.
std::string png_bytes(std::int64_t width, std::int64_t height, std::span<const Colour> pixels);

struct PictureSize {
  std::int64_t width = 0, height = 0;
};

/// A picture in memory, from the top line on.
struct ReadPicture {
  std::int64_t width = 0, height = 0;
  std::vector<Colour> pixels;  ///< Empty if only the header was wanted.
  bool is_lossy = false;       ///< Whether it was a JPEG.
  /// The pixels of a lossy picture that may have had another colour, in ascending order.
  std::vector<std::uint32_t> unclear = {};
  std::vector<float> depths = {};  ///< The first channels of a PFM, as they are.
  bool has_size(const PictureSize& size) const {
    return width == size.width && height == size.height;
  }
};

/// The bytes are not a picture, or the picture is too large; what() gives the reason.
class PictureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a PPM (P3 or P6, with comments; channels are scaled from any maximum to 255), a PNG or a
/// PFM (grey or in colour; channels are clamped to [0, 1]). Transparent pixels of a PNG are black;
/// in a picture that has such pixels, black ones that are not transparent are (1, 1, 1) instead. A
/// picture of more than `most` pixels is an error. If `wanted` is given and the picture has another
/// size, only its header is read.
ReadPicture parse_picture(std::string_view bytes, std::int64_t most,
                          const std::optional<PictureSize>& wanted = {});

}  // namespace raycheck::tools
