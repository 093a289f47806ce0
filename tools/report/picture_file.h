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

/// The most pixels of a picture across, and down: libpng's limit.
inline constexpr std::int64_t kMostPictureSide = 1'000'000;

class PictureEncoder {
 public:
  virtual ~PictureEncoder() = default;
  virtual void start(std::int64_t width, std::int64_t height) = 0;
  virtual void add(std::span<const Colour> line) = 0;
  virtual void finish() = 0;
};

/// A picture named by an option, written line by line, the top one first: PNG or PPM (P6), by its
/// file extension. Like an OutputFile it appears completely or not at all.
/// Error: functions throw std::runtime_error if the picture cannot be written.
class PictureFile {
 public:
  /// Throws std::invalid_argument naming the option if the extension is another; and as OutputFile.
  PictureFile(std::string option, std::string path);

  const std::string& path() const { return path_; }
  /// Domain: no side above kMostPictureSide.
  void start(std::int64_t width, std::int64_t height);
  /// The next lines; all of them together are the picture.
  void add(std::span<const Colour> lines);
  void place();

 private:
  std::string path_;
  OutputFile file_;
  std::unique_ptr<PictureEncoder> encoder_;
  std::size_t width_ = 0;
};

/// The bytes of a PNG file; the first line of pixels is the top one.
/// Domain: width x height pixels, at least one, no side above kMostPictureSide.
/// Error: std::runtime_error with what libpng says.
std::string png_bytes(std::int64_t width, std::int64_t height, std::span<const Colour> pixels);

struct PictureSize {
  std::int64_t width = 0, height = 0;
};

/// A picture in memory, the top line first.
struct ReadPicture {
  std::int64_t width = 0, height = 0;
  std::vector<Colour> pixels;  ///< Empty if only the header was wanted.
  bool has_size(const PictureSize& size) const {
    return width == size.width && height == size.height;
  }
};

/// Bytes that are not a picture, or one that is too large; what() says why.
class PictureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a PPM (P3 or P6, with comments; channels of any maximum are brought to 255) or a PNG.
/// Pictures of more than `most` pixels are errors. `wanted`: only the header is read of a
/// picture of another size.
ReadPicture parse_picture(std::string_view bytes, std::int64_t most,
                          const std::optional<PictureSize>& wanted = {});

}  // namespace raycheck::tools
