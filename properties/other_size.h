#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace raycheck::properties {

/// What a candidate's `image` throws where the picture has another size than the scene's.
class OtherSize : public std::runtime_error {
 public:
  OtherSize(const std::string& what, std::int64_t width, std::int64_t height)
      : std::runtime_error(what), width_(width), height_(height) {}
  std::int64_t width() const { return width_; }
  std::int64_t height() const { return height_; }

 private:
  std::int64_t width_, height_;
};

}  // namespace raycheck::properties
