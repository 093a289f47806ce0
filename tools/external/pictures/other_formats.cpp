#include "tools/external/pictures/other_formats.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "properties/failures.h"
#include "tools/external/pictures/renderer.h"
#include "tools/external/pictures/sphere_colours.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/external/sandbox/process.h"

namespace raycheck::tools {
namespace {

constexpr const char* kGiven = "picture";
constexpr const char* kConverted = "picture.ppm";
/// The limit on the header of a converted picture.
constexpr std::uint64_t kMostHeader = 4096;

/// A format that ImageMagick reads.
struct OtherFormat {
  const char* name;
  std::string_view beginning;  ///< Of its files; empty for TGA.
  bool is_linear;              ///< Whether ImageMagick would encode its channels as sRGB.
  const char* packages = "the Debian package imagemagick";
};
constexpr std::size_t kJpeg = 0;
constexpr std::array kOtherFormats = {
    OtherFormat{"JPEG", "\xff\xd8\xff", false}, OtherFormat{"BMP", "BM", false},
    OtherFormat{"HDR", "#?", true},
    OtherFormat{"EXR", "\x76\x2f\x31\x01", true,
                "the Debian packages imagemagick and libmagickcore-*-extra"},
    OtherFormat{"TGA", "", false}};

/// Whether the header can be that of a TGA, which has no signature.
bool may_be_tga(std::string_view bytes) {
  constexpr std::size_t kHeader = 18, kColourMap = 1, kType = 2, kDepth = 16;
  constexpr std::string_view kTypes("\1\2\3\x9\xa\xb"), kDepths("\x8\xf\x10\x18\x20");
  return bytes.size() > kHeader && static_cast<unsigned char>(bytes[kColourMap]) <= 1 &&
         kTypes.find(bytes[kType]) != std::string_view::npos &&
         kDepths.find(bytes[kDepth]) != std::string_view::npos;
}

const OtherFormat* other_format(std::string_view bytes) {
  const auto* const found = std::ranges::find_if(kOtherFormats, [&](const OtherFormat& format) {
    return format.beginning.empty() ? may_be_tga(bytes) : bytes.starts_with(format.beginning);
  });
  return found == kOtherFormats.end() ? nullptr : found;
}

/// "improper image header" from "convert: improper image header `picture' @ error/bmp.c/...".
std::string reason_in(const std::string& output) {
  const std::size_t colon = output.find(": ");
  if (colon == std::string::npos) return "ImageMagick gives no reason";
  const std::size_t begin = colon + 2;
  return boost::algorithm::trim_right_copy(
      output.substr(begin, output.find_first_of("`@\n", begin) - begin));
}

class ImageMagick {
 public:
  ImageMagick(const OtherFormat& format, const Confined& program) : format_(format) {
    confined_.layers = program.layers;
    confined_.surroundings = program.surroundings;
    confined_.spent = program.spent;
    confined_.limits.file = kMostHeader + sizeof(Colour) * std::uint64_t{kMostPicturePixels};
  }

  ReadPicture read(const std::string& bytes, const PictureSize& size) {
    if (program().empty()) refuse();
    // ImageMagick ignores the order of an HDR's rows.
    is_bottom_first_ =
        format_.is_linear && bytes.substr(0, kMostHeader).find("\n\n+Y ") != std::string::npos;
    std::string why;
    if (auto picture = converted({}, {{kGiven, bytes}}, size, why)) return *std::move(picture);
    // The picture is at fault only if a picture that ImageMagick itself writes is read.
    const std::string sample = fmt::format("{}:{}", format_.name, kGiven);
    if (std::string ignored;
        !converted({"-size", "8x8", "xc:#f00", "-write", sample, "+delete"}, {}, {8, 8}, ignored)) {
      refuse();
    }
    throw PictureError(fmt::format("its {} cannot be read: {}", format_.name, why));
  }

 private:
  static std::string program() {
    for (const char* name : {"magick", "convert"}) {
      if (is_on_path(name)) return name;
    }
    return "";
  }

  [[noreturn]] void refuse() const {
    const std::string why = fmt::format(
        "its picture has the format {}, which raycheck reads by ImageMagick: install {}",
        format_.name, format_.packages);
    if (confined_.surroundings) confined_.surroundings->blame(why);
    throw properties::CannotBeSaid(why);
  }

  /// Runs ImageMagick on these files; `first` are commands before it reads the picture. Empty if
  /// that fails; `why` is then the reason.
  std::optional<ReadPicture> converted(std::vector<std::string> first,
                                       std::vector<StartingFolder::File> files,
                                       const PictureSize& size, std::string& why) const try {
    Confined run = confined_;
    run.files = std::move(files);
    // Without limits, it would keep the pixels of a picture that is too large in a file.
    run.arguments = {program(), "-limit", "thread", "1",      "-limit", "memory", "1GiB",
                     "-limit",  "map",    "0",      "-limit", "disk",   "0"};
    const auto add = [&](const std::vector<std::string>& words) {
      run.arguments.insert(run.arguments.end(), words.begin(), words.end());
    };
    add(first);
    add({fmt::format("{}:{}", format_.name, kGiven), "-auto-orient", "-strip", "-alpha", "off"});
    if (format_.is_linear) add({"-set", "colorspace", "sRGB"});
    if (is_bottom_first_) add({"-flip"});
    add({"-depth", "8", fmt::format("ppm:{}", kConverted)});
    Process process(run);
    const int code = process.finish();
    const std::string said = process.error_output().text();
    // It reads an incomplete JPEG with a warning.
    if (code != 0 || said.find("remature end of ") != std::string::npos) {
      why = reason_in(said);
      return {};
    }
    return parse_picture(file_bytes(process.folder() / kConverted, run.limits.file),
                         kMostPicturePixels, size);
  } catch (const ProcessFailure& failure) {
    if (failure.kind() == FailureKind::kSystem) throw;
    why = fmt::format("ImageMagick {}", failure.why());
    return {};
  }

  const OtherFormat& format_;
  Confined confined_;
  bool is_bottom_first_ = false;
};

}  // namespace

bool is_picture_name(std::string_view name) {
  constexpr std::array<std::string_view, 10> kEndings = {".ppm", ".pnm", ".png",  ".pfm", ".bmp",
                                                         ".tga", ".jpg", ".jpeg", ".hdr", ".exr"};
  return std::ranges::any_of(kEndings, [&](std::string_view ending) {
    return boost::algorithm::iends_with(name, ending);
  });
}

ReadPicture read_picture(const std::string& bytes, const Confined& program, const PictureSize& size,
                         const Colour& background) {
  const OtherFormat* const format = other_format(bytes);
  if (format == nullptr) return parse_picture(bytes, kMostPicturePixels, size);
  ReadPicture picture = ImageMagick(*format, program).read(bytes, size);
  if (format == &kOtherFormats[kJpeg]) restore_colours(picture, background);
  return picture;
}

}  // namespace raycheck::tools
