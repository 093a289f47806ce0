#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "reference/visibility/visibility.h"
#include "scene/plan/plan.h"
#include "tools/check/check.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {
namespace {

/// The longer side of the picture, whatever the image has.
constexpr std::int64_t kLongerSide = 320;

constexpr Colour kUnseen = {244, 244, 246};
constexpr Colour kSeen = {176, 184, 196};
/// By standing: red, purple, pink, grey.
constexpr std::array<Colour, properties::kStandingCount> kMarks = {
    {{214, 0, 0}, {120, 0, 150}, {255, 140, 180}, {120, 120, 120}}};

struct Canvas {
  std::int64_t width = 1, height = 1;
  std::vector<Colour> pixels;  ///< From the top.
};

/// Exact silhouettes of the scene at the size of the canvas.
void draw_silhouettes(Canvas& canvas, scene::Scene scene) {
  const bool top_first = scene.conventions.rows == scene::Rows::kTopFirst;
  scene.camera->width = canvas.width;
  scene.camera->height = canvas.height;
  std::vector<std::int32_t> seen(canvas.pixels.size());
  reference::SeenRows rows{};
  rows.sphere = seen;
  const reference::Visibility visibility(
      scene, scene::plan_scene(scene, scene.conventions, scene::Wanted::kNearest));
  visibility.nearest(0, canvas.height, rows);
  for (std::int64_t j = 0; j < canvas.height; ++j) {
    const std::int64_t line = top_first ? j : canvas.height - 1 - j;
    for (std::int64_t i = 0; i < canvas.width; ++i) {
      const bool is_seen = seen[static_cast<std::size_t>(j * canvas.width + i)] >= 0;
      canvas.pixels[static_cast<std::size_t>(line * canvas.width + i)] = is_seen ? kSeen : kUnseen;
    }
  }
}

/// Where on a side of the canvas a column or a row of an image is sampled.
std::int64_t position(std::int64_t index, std::int64_t count, std::int64_t side,
                      scene::Samples samples) {
  if (samples == scene::Samples::kCentres) return (2 * index + 1) * side / (2 * count);
  return count == 1 ? 0 : index * (side - 1) / (count - 1);
}

/// A square around a place, of half of what a pixel of the image takes.
void mark(Canvas& canvas, const scene::Scene& scene, const scene::Pixel& pixel,
          const Colour& colour) {
  const scene::Camera& camera = *scene.camera;
  const std::int64_t half =
      std::max<std::int64_t>(canvas.width / std::max(camera.width, camera.height) / 4, 1);
  const scene::Samples samples = scene.conventions.samples;
  const std::int64_t x = position(pixel.i, camera.width, canvas.width, samples);
  const std::int64_t row = position(pixel.j, camera.height, canvas.height, samples);
  const bool top_first = scene.conventions.rows == scene::Rows::kTopFirst;
  const std::int64_t y = top_first ? row : canvas.height - 1 - row;
  for (std::int64_t j = std::max<std::int64_t>(y - half, 0);
       j <= std::min(y + half, canvas.height - 1); ++j) {
    for (std::int64_t i = std::max<std::int64_t>(x - half, 0);
         i <= std::min(x + half, canvas.width - 1); ++i) {
      canvas.pixels[static_cast<std::size_t>(j * canvas.width + i)] = colour;
    }
  }
}

}  // namespace

std::string check_picture(const CheckReport& report, const ViewOptions& /*options*/) {
  Canvas canvas;
  canvas.pixels.assign(1, kUnseen);
  if (report.scene.camera) {
    const scene::Camera& camera = *report.scene.camera;
    const std::int64_t longer = std::max(camera.width, camera.height);
    canvas.width = std::max<std::int64_t>(camera.width * kLongerSide / longer, 2);
    canvas.height = std::max<std::int64_t>(camera.height * kLongerSide / longer, 2);
    canvas.pixels.assign(static_cast<std::size_t>(canvas.width * canvas.height), kUnseen);
    draw_silhouettes(canvas, report.scene);
    for (const CandidateReport& candidate : report.candidates) {
      auto worst = candidate.verdict.worst(properties::kKeptDiscrepancies);
      std::reverse(worst.begin(), worst.end());  // defects last, on top
      for (const auto& one : worst) {
        if (!one.place.pixel) continue;
        mark(canvas, report.scene, *one.place.pixel,
             kMarks[static_cast<std::size_t>(one.excuse.standing())]);
      }
    }
  }
  return png_bytes(canvas.width, canvas.height, canvas.pixels);
}

}  // namespace raycheck::tools
