#include "tools/report/picture_file.h"

#include <fmt/core.h>
#include <png.h>

#include <csetjmp>
#include <exception>
#include <stdexcept>
#include <utility>

namespace raycheck::tools {
namespace {

class PpmEncoder : public PictureEncoder {
 public:
  explicit PpmEncoder(OutputFile& file) : file_(file) {}

  void start(std::int64_t width, std::int64_t height) override {
    file_.append(fmt::format("P6\n{} {}\n255\n", width, height));
  }
  void add(std::span<const Colour> line) override {
    file_.append({reinterpret_cast<const char*>(line.data()), line.size_bytes()});
  }
  void finish() override {}

 private:
  OutputFile& file_;
};

/// libpng leaves a failed call by longjmp; nothing that has a destructor lives between guarded()
/// and such a call.
class PngEncoder : public PictureEncoder {
 public:
  explicit PngEncoder(OutputFile& file) : file_(file) {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      file.fail("libpng: it cannot be used");
    }
  }
  PngEncoder(const PngEncoder&) = delete;
  PngEncoder& operator=(const PngEncoder&) = delete;
  ~PngEncoder() override { png_destroy_write_struct(&png_, &info_); }

  void start(std::int64_t width, std::int64_t height) override {
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
  void add(std::span<const Colour> line) override {
    guarded([&] { png_write_row(png_, reinterpret_cast<png_const_bytep>(line.data())); });
  }
  void finish() override {
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
  std::exception_ptr failure_;  ///< Of the file.
  std::string message_;         ///< Of libpng.
};

std::unique_ptr<PictureEncoder> encoder_for(const std::string& option, const std::string& path,
                                            OutputFile& file) {
  if (path.ends_with(".png")) return std::make_unique<PngEncoder>(file);
  if (path.ends_with(".ppm")) return std::make_unique<PpmEncoder>(file);
  throw std::invalid_argument(
      fmt::format("{} {}: a picture's name ends in .png or .ppm", option, path));
}

}  // namespace

PictureFile::PictureFile(std::string option, std::string path)
    : path_(path), file_(option, std::move(path)), encoder_(encoder_for(option, path_, file_)) {}

void PictureFile::start(std::int64_t width, std::int64_t height) {
  const auto require = [](const char* side, std::int64_t pixels) {
    if (pixels <= kMostPictureSide) return;
    throw std::invalid_argument(
        fmt::format("camera.{}: {} pixels are more than a picture takes, "
                    "which is {}",
                    side, pixels, kMostPictureSide));
  };
  require("width", width);
  require("height", height);
  width_ = static_cast<std::size_t>(width);
  encoder_->start(width, height);
}

void PictureFile::add(std::span<const Colour> lines) {
  for (std::size_t at = 0; at < lines.size(); at += width_) {
    encoder_->add(lines.subspan(at, width_));
  }
}

void PictureFile::place() {
  encoder_->finish();
  file_.place();
}

}  // namespace raycheck::tools
