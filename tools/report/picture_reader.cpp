#include "tools/report/picture_reader.h"

#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <charconv>

namespace raycheck::tools {
namespace {

constexpr std::string_view kSpace = " \t\r\n\v\f";

void require_size(std::int64_t width, std::int64_t height, std::int64_t most) {
  if (width < 1 || height < 1 || width > most || height > most / width) {
    throw PictureError(fmt::format("its picture has {} x {} pixels", width, height));
  }
}

/// The words of a PPM; a comment goes from # to the end of its line.
class PpmWords {
 public:
  explicit PpmWords(std::string_view text) : rest_(text) {}

  std::int64_t number() {
    skip();
    std::int64_t value = 0;
    const auto [at, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) throw PictureError("its PPM has a word that is no number, or ends");
    rest_.remove_prefix(static_cast<std::size_t>(at - rest_.data()));
    return value;
  }
  /// What follows the one space after the last word.
  std::string_view bytes() const { return rest_.substr(rest_.empty() ? 0 : 1); }

 private:
  void skip() {
    for (;;) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(kSpace), rest_.size()));
      if (!rest_.starts_with('#')) return;
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
    }
  }

  std::string_view rest_;
};

ReadPicture read_ppm(std::string_view bytes, std::int64_t most,
                     const std::optional<PictureSize>& wanted) {
  const bool is_text = bytes[1] == '3';
  PpmWords words(bytes.substr(2));
  ReadPicture picture;
  picture.width = words.number();
  picture.height = words.number();
  require_size(picture.width, picture.height, most);
  if (wanted && !picture.has_size(*wanted)) return picture;
  const std::int64_t largest = words.number();
  if (largest < 1 || largest > 65535) {
    throw PictureError(fmt::format("its PPM's largest channel is {}", largest));
  }
  const auto count = static_cast<std::size_t>(picture.width * picture.height);
  const std::size_t size = largest < 256 ? 1 : 2;
  std::string_view rest;
  if (!is_text) {
    rest = words.bytes();
    // A line that Windows ended has one byte more than the one that the format allows.
    if (rest.starts_with('\n') && rest.size() == 3 * size * count + 1) rest.remove_prefix(1);
    if (rest.size() < 3 * size * count) throw PictureError("its PPM ends before its pixels");
  }
  const auto channel = [&] {
    std::int64_t value = 0;
    if (is_text) {
      value = words.number();
    } else {
      for (std::size_t k = 0; k < size; ++k) {
        value = 256 * value + static_cast<unsigned char>(rest[k]);
      }
      rest.remove_prefix(size);
    }
    if (value < 0 || value > largest) {
      throw PictureError(fmt::format("its PPM has the channel {} of at most {}", value, largest));
    }
    return static_cast<std::uint8_t>((255 * value + largest / 2) / largest);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint8_t red = channel(), green = channel(), blue = channel();
    picture.pixels.push_back({red, green, blue});
  }
  return picture;
}

ReadPicture read_png(std::string_view bytes, std::int64_t most,
                     const std::optional<PictureSize>& wanted) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.flags = PNG_IMAGE_FLAG_16BIT_sRGB;  // what renderers mean, not linear light
  const auto require = [&](int done) {
    if (done == 0) {
      const std::string why = image.message;
      png_image_free(&image);
      throw PictureError("its PNG: " + why);
    }
  };
  require(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  ReadPicture picture;
  picture.width = image.width;
  picture.height = image.height;
  const bool is_wanted = !wanted || picture.has_size(*wanted);
  if (!is_wanted || picture.width > most / picture.height) png_image_free(&image);
  require_size(picture.width, picture.height, most);
  if (!is_wanted) return picture;
  image.format = PNG_FORMAT_RGB;
  picture.pixels.resize(static_cast<std::size_t>(picture.width * picture.height));
  const png_color background = {0, 0, 0};
  require(png_image_finish_read(&image, &background, picture.pixels.data(), 0, nullptr));
  return picture;
}

}  // namespace

ReadPicture parse_picture(std::string_view bytes, std::int64_t most,
                          const std::optional<PictureSize>& wanted) {
  if (bytes.starts_with("P3") || bytes.starts_with("P6")) return read_ppm(bytes, most, wanted);
  if (bytes.starts_with("\x89PNG")) return read_png(bytes, most, wanted);
  throw PictureError(bytes.empty() ? "its picture is empty"
                                   : "its picture is neither a PPM (P3 or P6) nor a PNG");
}

}  // namespace raycheck::tools
