#include "tools/report/picture_file.h"

#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <csetjmp>
#include <exception>
#include <utility>

namespace raycheck::tools {

/// libpng leaves a failed call by longjmp. No object with a destructor may exist between guarded()
/// and such a call.
class PngEncoder {
 public:
  explicit PngEncoder(OutputFile& file) : file_(file) {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      file.fail("libpng: cannot be initialised");
    }
  }
  PngEncoder(const PngEncoder&) = delete;
  PngEncoder& operator=(const PngEncoder&) = delete;
  ~PngEncoder() { png_destroy_write_struct(&png_, &info_); }

  void start(std::int64_t width, std::int64_t height) {
    guarded([&] {
      png_set_write_fn(png_, this, on_write, on_flush);
      png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                   8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                   PNG_FILTER_TYPE_DEFAULT);
      png_set_compression_level(png_, kCompressionLevel);
      png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
      png_write_info(png_, info_);
    });
  }
  void add(std::span<const Colour> line) {
    guarded([&] { png_write_row(png_, reinterpret_cast<png_const_bytep>(line.data())); });
  }
  void finish() {
    guarded([&] { png_write_end(png_, info_); });
  }

 private:
  static constexpr int kCompressionLevel = 6;

  template <class Call>
  void guarded(const Call& call) {
    if (setjmp(png_jmpbuf(png_)) == 0) {
      call();
      return;
    }
    if (failure_) std::rethrow_exception(failure_);
    file_.fail("libpng: " + message_);
  }

  static void on_write(png_structp png, png_bytep bytes, png_size_t size) {
    auto& self = *static_cast<PngEncoder*>(png_get_io_ptr(png));
    try {
      self.file_.append({reinterpret_cast<const char*>(bytes), size});
    } catch (...) {
      self.failure_ = std::current_exception();
    }
    if (self.failure_) png_longjmp(png, 1);
  }
  static void on_flush(png_structp) {}
  static void on_error(png_structp png, png_const_charp message) {
    static_cast<PngEncoder*>(png_get_error_ptr(png))->message_ = message;
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}

  OutputFile& file_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::exception_ptr failure_;  ///< The failure of the file.
  std::string message_;         ///< The message of libpng.
};

PictureFile::PictureFile(std::string option, std::string path)
    : path_(path), file_(option, std::move(path)) {
  if (path_.ends_with(".png")) {
    png_ = std::make_unique<PngEncoder>(file_);
  } else if (!path_.ends_with(".ppm")) {
    throw std::invalid_argument(
        fmt::format("{} {}: the name of a picture must end in .png or .ppm", option, path_));
  }
}

PictureFile::~PictureFile() = default;

void PictureFile::start(std::int64_t width, std::int64_t height) {
  width_ = static_cast<std::size_t>(width);
  if (png_) return png_->start(width, height);
  file_.append(fmt::format("P6\n{} {}\n255\n", width, height));
}

void PictureFile::add(std::span<const Colour> lines) {
  for (std::size_t at = 0; png_ && at < lines.size(); at += width_) {
    png_->add(lines.subspan(at, width_));
  }
  if (!png_) file_.append({reinterpret_cast<const char*>(lines.data()), lines.size_bytes()});
}

void PictureFile::place() {
  if (png_) png_->finish();
  file_.place();
}

std::string png_bytes(std::int64_t width, std::int64_t height, std::span<const Colour> pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("libpng: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

namespace {

constexpr std::string_view kSpace = " \t\r\n\v\f";

void require_size(std::int64_t width, std::int64_t height, std::int64_t most) {
  if (width < 1 || height < 1 || width > most || height > most / width) {
    throw PictureError(fmt::format("its picture has {} x {} pixels", width, height));
  }
}

/// The words of a PPM or PFM. A comment goes from # to the end of its line.
class PictureWords {
 public:
  PictureWords(const char* format, std::string_view text) : format_(format), rest_(text) {}

  template <class Number = std::int64_t>
  Number number() {
    skip();
    if (rest_.starts_with('+')) rest_.remove_prefix(1);
    Number value = 0;
    const auto [at, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) {
      throw PictureError(
          fmt::format("its {} has a word that is not a number, or ends too early", format_));
    }
    rest_.remove_prefix(static_cast<std::size_t>(at - rest_.data()));
    return value;
  }
  /// The pixels, of this many bytes: what follows the one space that ends the last word. A space or
  /// a carriage return before the line end is one byte more than the formats allow.
  std::string_view pixels(std::size_t size) const {
    std::string_view rest = rest_.substr(rest_.empty() ? 0 : 1);
    const bool is_line_end = !rest_.starts_with('\n') && rest.starts_with('\n');
    if (is_line_end && rest.size() == size + 1) rest.remove_prefix(1);
    if (rest.size() < size) throw PictureError(fmt::format("its {} lacks pixels", format_));
    return rest;
  }

 private:
  void skip() {
    for (;;) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(kSpace), rest_.size()));
      if (!rest_.starts_with('#')) return;
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
    }
  }

  const char* format_;
  std::string_view rest_;
};

ReadPicture read_ppm(std::string_view bytes, std::int64_t most,
                     const std::optional<PictureSize>& wanted) {
  const bool is_text = bytes[1] == '3';
  PictureWords words("PPM", bytes.substr(2));
  ReadPicture picture;
  picture.width = words.number();
  picture.height = words.number();
  require_size(picture.width, picture.height, most);
  if (wanted && !picture.has_size(*wanted)) return picture;
  const std::int64_t largest = words.number();
  if (largest < 1 || largest > 65535) {
    throw PictureError(fmt::format("its PPM's maximum channel is {}, not 1 to 65535", largest));
  }
  const auto count = static_cast<std::size_t>(picture.width * picture.height);
  const std::size_t size = largest < 256 ? 1 : 2;
  std::string_view rest = is_text ? "" : words.pixels(3 * size * count);
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
      throw PictureError(fmt::format("its PPM has channel {}, maximum {}", value, largest));
    }
    return static_cast<std::uint8_t>((255 * value + largest / 2) / largest);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint8_t red = channel(), green = channel(), blue = channel();
    picture.pixels.push_back({red, green, blue});
  }
  return picture;
}

/// The rows of a PFM are stored from the bottom to the top. The sign of its scale is the order of
/// the bytes; programs disagree about what the absolute value means, which is ignored.
ReadPicture read_pfm(std::string_view bytes, std::int64_t most,
                     const std::optional<PictureSize>& wanted) {
  const std::size_t channels = bytes[1] == 'F' ? 3 : 1;
  PictureWords words("PFM", bytes.substr(2));
  ReadPicture picture;
  picture.width = words.number();
  picture.height = words.number();
  require_size(picture.width, picture.height, most);
  if (wanted && !picture.has_size(*wanted)) return picture;
  const bool is_little = words.number<double>() < 0;
  const auto row = static_cast<std::size_t>(picture.width) * channels * sizeof(float);
  const std::string_view rest = words.pixels(row * static_cast<std::size_t>(picture.height));
  const auto channel = [&](std::string_view at) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < sizeof(word); ++k) {
      word = 256 * word + static_cast<unsigned char>(at[is_little ? sizeof(word) - 1 - k : k]);
    }
    return std::bit_cast<float>(word);
  };
  for (std::int64_t line = picture.height - 1; line >= 0; --line) {
    for (std::size_t at = static_cast<std::size_t>(line) * row, end = at + row; at < end;
         at += channels * sizeof(float)) {
      picture.depths.push_back(channel(rest.substr(at)));
      const auto part = [&](std::size_t k) {
        const float value = channel(rest.substr(at + k % channels * sizeof(float)));
        return static_cast<std::uint8_t>(255 * (value > 0 ? std::min(value, 1.0F) : 0) + 0.5F);
      };
      picture.pixels.push_back({part(0), part(1), part(2)});
    }
  }
  return picture;
}

ReadPicture read_png(std::string_view bytes, std::int64_t most,
                     const std::optional<PictureSize>& wanted) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.flags = PNG_IMAGE_FLAG_16BIT_sRGB;  // renderers write sRGB, not linear light
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
  image.format = PNG_FORMAT_RGBA;
  struct Layered {
    Colour colour;
    std::uint8_t opacity;
  };
  std::vector<Layered> read(static_cast<std::size_t>(picture.width * picture.height));
  require(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr));
  const bool some_transparent =
      std::ranges::any_of(read, [](const Layered& one) { return one.opacity == 0; });
  picture.pixels.reserve(read.size());
  for (const Layered& one : read) {
    const auto on_black = [&one](std::uint8_t channel) {
      return static_cast<std::uint8_t>((channel * one.opacity + 127) / 255);
    };
    Colour shown = {on_black(one.colour.red), on_black(one.colour.green),
                    on_black(one.colour.blue)};
    if (some_transparent && one.opacity != 0 && shown == Colour{}) shown = {1, 1, 1};
    picture.pixels.push_back(shown);
  }
  return picture;
}

}  // namespace

ReadPicture parse_picture(std::string_view bytes, std::int64_t most,
                          const std::optional<PictureSize>& wanted) {
  if (bytes.starts_with("P3") || bytes.starts_with("P6")) return read_ppm(bytes, most, wanted);
  if (bytes.starts_with("PF") || bytes.starts_with("Pf")) return read_pfm(bytes, most, wanted);
  if (bytes.starts_with("\x89PNG")) return read_png(bytes, most, wanted);
  throw PictureError(bytes.empty() ? "its picture is empty"
                                   : "its picture is not a PPM (P3, P6), PNG, PFM, BMP, TGA, JPEG, "
                                     "HDR or EXR");
}

}  // namespace raycheck::tools
