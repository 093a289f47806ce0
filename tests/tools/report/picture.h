#pragma once

#include <png.h>

#include <cstring>

#include "tests/tools/program.h"

namespace raycheck::tests {

/// A decoded picture: line 0 is the top one.
struct ReadPicture {
  std::int64_t width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;

  const std::array<std::uint8_t, 3>& at(std::int64_t column, std::int64_t line) const {
    return pixels.at(static_cast<std::size_t>(line * width + column));
  }
  /// Whether two files show the same picture, however compressed.
  bool operator==(const ReadPicture&) const = default;
};

inline ReadPicture read_png(const std::string& bytes) {
  ReadPicture picture;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0)
      << image.message;
  image.format = PNG_FORMAT_RGB;
  picture.width = image.width;
  picture.height = image.height;
  picture.pixels.resize(std::size_t{image.width} * image.height);
  EXPECT_NE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr), 0)
      << image.message;
  return picture;
}

inline ReadPicture read_ppm(const std::string& bytes) {
  ReadPicture picture;
  std::istringstream header(bytes);
  std::string magic;
  int most = 0;
  header >> magic >> picture.width >> picture.height >> most;
  EXPECT_EQ(magic, "P6");
  EXPECT_EQ(most, 255);
  const auto start = static_cast<std::size_t>(header.tellg()) + 1;
  picture.pixels.resize(static_cast<std::size_t>(picture.width * picture.height));
  EXPECT_EQ(bytes.size(), start + 3 * picture.pixels.size());
  if (bytes.size() == start + 3 * picture.pixels.size()) {
    std::memcpy(picture.pixels.data(), bytes.data() + start, bytes.size() - start);
  }
  return picture;
}

/// Decodes PNG or PPM (P6); empty, with a failure of the test, if it is neither.
inline ReadPicture read_picture(const std::string& path) {
  const std::string bytes = contents(path);
  if (bytes.rfind("\x89PNG", 0) == 0) return read_png(bytes);
  return read_ppm(bytes);
}

}  // namespace raycheck::tests
