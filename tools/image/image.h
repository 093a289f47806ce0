#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/excuse.h"
#include "properties/run_control.h"
#include "reference/visibility/visibility.h"
#include "scene/files/scene_file.h"
#include "tools/implementations/built_in.h"
#include "tools/report/picture_file.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// The kinds of pictures.
enum class Picture { kSphere, kError };
inline constexpr std::array<std::string_view, 2> kPictureNames = {"sphere", "error"};
constexpr std::string_view name(Picture picture) {
  return kPictureNames[static_cast<std::size_t>(picture)];
}

struct ImageOptions {
  std::string path;
  const scene::FileFormat* read_as = nullptr;
  Picture what = Picture::kSphere;
  Implementation implementation = {};    ///< The candidate whose error is shown.
  MethodPair methods = kDefaultMethods;  ///< These make the rays if the candidate does not.
  std::optional<scene::Pixel> size;      ///< Pixels across and down, instead of the scene's.
};

/// The numbers of pixels in a picture of errors, by the error of s.
struct ErrorCounts {
  std::string candidate;
  Implementation implementation;
  /// The format in whose ulp errors are counted.
  scene::Precision precision = scene::Precision::kDouble;
  std::size_t rounded_numbers = 0;  ///< The count of scene numbers that were rounded.
  /// Pixels without an answer, which are defects. In each batch of 512 pixels, at most
  /// kMostFailuresSought are searched for; after that, other pixels that fail with them count, too.
  std::uint64_t failed = 0;
  std::string first_failure;
  /// The number of pixels for each of kErrorSteps (image_paint.h).
  std::vector<std::uint64_t> pixels;
  /// The number of missed hits, false hits and wrong spheres, by standing.
  std::array<std::uint64_t, properties::kStandingCount> wrong = {};

  std::uint64_t count(properties::Standing standing) const {
    return wrong[static_cast<std::size_t>(standing)];
  }
};

struct ImageReport {
  std::string path;
  std::string file;
  Picture what = Picture::kSphere;
  std::vector<std::string> warnings;
  std::string format;                   ///< Of a file that is not TOML.
  std::vector<std::string> not_needed;  ///< Settings of the scene file that are not needed here.
  scene::Conventions conventions;       ///< The picture's conventions.
  std::int64_t width = 0;
  std::int64_t height = 0;
  std::size_t spheres = 0;
  std::size_t spheres_seen = 0;
  std::uint64_t pixels_that_see = 0;
  reference::DecidedBy decided_by;
  std::optional<ErrorCounts> error;  ///< For Picture::kError.
  int threads = 1;
  double seconds = 0;
  bool interrupted = false;  ///< If true, no picture was written.
};

/// Decides every pixel of a scene and writes the picture, in bands of rows, so that neither the
/// picture nor its data is in memory as a whole. The file does not depend on the number of threads.
/// Domain: a scene with a camera of at most kMostPictureSide pixels per side, fewer than 2^31
///         spheres; otherwise throws std::invalid_argument naming the file or the field. Also
///         throws what the reader and PictureFile throw.
ImageReport make_image(const ImageOptions& options, PictureFile& file,
                       const properties::RunControl& control = {});

std::string image_text(const ImageReport& report, const ViewOptions& options);
std::string image_json(const ImageReport& report, const ViewOptions& options);

inline constexpr View<ImageReport> kImageViews[] = {
    {"text", image_text},
    {"json", image_json},
};

}  // namespace raycheck::tools
