#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "reference/visibility/visibility.h"
#include "scene/plan/plan.h"
#include "tools/check/check_views.h"
#include "tools/report/png.h"

namespace raycheck::tools {
namespace {

/// Larger images are shown at a fraction of their size.
constexpr std::int64_t kMostSide = 320;
/// What is wrong is at least so many points wide.
constexpr std::int64_t kMarkSide = 3;

constexpr Colour kNothing = {244, 244, 246};
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
      canvas.pixels[static_cast<std::size_t>(line * canvas.width + i)] = is_seen ? kSeen : kNothing;
    }
  }
}

void mark(Canvas& canvas, std::int64_t x, std::int64_t y, const Colour& colour) {
  constexpr std::int64_t kHalf = kMarkSide / 2;
  for (std::int64_t j = std::max<std::int64_t>(y - kHalf, 0);
       j <= std::min(y + kHalf, canvas.height - 1); ++j) {
    for (std::int64_t i = std::max<std::int64_t>(x - kHalf, 0);
         i <= std::min(x + kHalf, canvas.width - 1); ++i) {
      canvas.pixels[static_cast<std::size_t>(j * canvas.width + i)] = colour;
    }
  }
}

}  // namespace

std::string check_picture(const CheckReport& report, const ViewOptions& /*options*/) {
  Canvas canvas;
  canvas.pixels.assign(1, kNothing);
  if (report.scene.camera) {
    const scene::Camera& camera = *report.scene.camera;
    const std::int64_t longer = std::max(camera.width, camera.height);
    const auto shrunk = [&](std::int64_t side) {
      return longer <= kMostSide ? side : std::max<std::int64_t>(side * kMostSide / longer, 2);
    };
    canvas.width = shrunk(camera.width);
    canvas.height = shrunk(camera.height);
    canvas.pixels.assign(static_cast<std::size_t>(canvas.width * canvas.height), kNothing);
    draw_silhouettes(canvas, report.scene);
    const bool top_first = report.scene.conventions.rows == scene::Rows::kTopFirst;
    for (const CandidateReport& candidate : report.candidates) {
      auto worst = candidate.verdict.worst(properties::kKeptDiscrepancies);
      std::reverse(worst.begin(), worst.end());  // defects last, on top
      for (const auto& one : worst) {
        if (!one.place.pixel) continue;
        const std::int64_t x = one.place.pixel->i * canvas.width / camera.width;
        const std::int64_t y = one.place.pixel->j * canvas.height / camera.height;
        mark(canvas, x, top_first ? y : canvas.height - 1 - y,
             kMarks[static_cast<std::size_t>(one.excuse.standing())]);
      }
    }
  }
  return png_bytes(canvas.width, canvas.height, canvas.pixels);
}

}  // namespace raycheck::tools
