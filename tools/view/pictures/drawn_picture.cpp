#include <algorithm>
#include <stdexcept>
#include <utility>

#include "properties/laws/law.h"
#include "properties/trial.h"
#include "tools/view/pictures/pictures.h"

namespace raycheck::tools {
namespace {

using properties::Discrepancy;

/// Pixels that are judged at a time: of so few a verdict keeps every discrepancy.
constexpr std::size_t kPixelsAtOnce = 512;
static_assert(kPixelsAtOnce <= properties::kKeptDiscrepancies);

std::int32_t pixel_of(const std::optional<std::size_t>& pixel) {
  return !pixel                              ? reference::kNoSphere
         : *pixel == properties::kSomeSphere ? kSomePixel
                                             : static_cast<std::int32_t>(*pixel);
}

class DrawnErrorPainter : public Painter {
 public:
  DrawnErrorPainter(const scene::Scene& scene, properties::Candidate candidate)
      : scene_(scene),
        candidate_(std::move(candidate)),
        laws_(properties::laws_that(
            [](const properties::Law& law) { return law.per == properties::Per::kImage; })) {}

  void paint(const SeenBand& band, std::span<Colour> pixels, ErrorCounts& errors) const override {
    errors.pixels.resize(kErrorSteps.size());
    for (std::size_t first = 0; first < pixels.size(); first += kPixelsAtOnce) {
      const std::size_t end = std::min(first + kPixelsAtOnce, pixels.size());
      paint_chunk(band.j_begin, first, pixels.subspan(first, end - first), errors);
    }
  }

 private:
  void paint_chunk(std::int64_t j_begin, std::size_t first, std::span<Colour> pixels,
                   ErrorCounts& errors) const {
    const std::int64_t width = scene_.camera->width;
    properties::Case chunk = {scene_, {}};
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const auto index = static_cast<std::int64_t>(first + k);
      chunk.pixels.push_back({index % width, j_begin + index / width});
    }
    std::fill(pixels.begin(), pixels.end(), kErrorSteps.front().colour);
    std::vector<bool> is_wrong(pixels.size());
    const auto mark = [&](std::size_t k, properties::Standing standing) {
      if (is_wrong[k]) return;
      is_wrong[k] = true;
      pixels[k] = kWrongColours[static_cast<std::size_t>(standing)];
      ++errors.wrong[static_cast<std::size_t>(standing)];
    };
    properties::Trial trial(chunk, candidate_);
    for (const properties::Law* law : laws_) {
      const properties::Verdict verdict = properties::apply(*law, trial);
      for (const Discrepancy& one : verdict.worst(kPixelsAtOnce)) {
        if (one.wrong == properties::Wrong::kFailed) {
          for (std::size_t k = 0; k < pixels.size(); ++k) mark(k, one.excuse.standing());
          if (errors.failed == 0) errors.first_failure = one.what;
          errors.failed += pixels.size();
        } else {
          mark(one.place.ray, one.excuse.standing());
        }
      }
    }
    errors.pixels.front() +=
        static_cast<std::uint64_t>(std::count(is_wrong.begin(), is_wrong.end(), false));
  }

  const scene::Scene& scene_;
  properties::Candidate candidate_;
  std::vector<const properties::Law*> laws_;
};

}  // namespace

std::vector<std::int32_t> drawn_picture(const scene::Scene& scene,
                                        const properties::Candidate& candidate) {
  const auto count = static_cast<std::size_t>(scene.camera->width * scene.camera->height);
  std::vector<std::int32_t> picture(count, kFailedPixel);
  try {
    const properties::ImageAnswer answer =
        candidate.image(scene, candidate.declared.over(scene.conventions));
    if (answer.size() == count) {
      std::transform(answer.begin(), answer.end(), picture.begin(), pixel_of);
    }
  } catch (const std::runtime_error&) {  // The findings say how it failed.
  }
  return picture;
}

std::unique_ptr<Painter> drawn_error_painter(const scene::Scene& scene,
                                             properties::Candidate candidate) {
  return std::make_unique<DrawnErrorPainter>(scene, std::move(candidate));
}

}  // namespace raycheck::tools
