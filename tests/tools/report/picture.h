#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace raycheck::tests {

/// A picture as any viewer reads it: line 0 is the top one.
struct ReadPicture {
  std::int64_t width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;

  const std::array<std::uint8_t, 3>& at(std::int64_t column, std::int64_t line) const {
    return pixels.at(static_cast<std::size_t>(line * width + column));
  }
  /// The same picture, however it is compressed.
  bool operator==(const ReadPicture&) const = default;
};

/// Decodes PNG or PPM (P6); empty, with a failure of the test, where it is neither.
ReadPicture read_picture(const std::string& path);

}  // namespace raycheck::tests
