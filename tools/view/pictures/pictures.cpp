#include "tools/view/pictures/pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <map>
#include <span>
#include <stdexcept>

#include "properties/trial.h"
#include "reference/visibility/visibility.h"
#include "tools/image/image_paint.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {
namespace {

using reference::kNoSphere;

constexpr Colour kFailedColour = {128, 128, 128};

/// Rows that are decided and painted at a time: between them an interrupt is heeded.
constexpr std::int64_t kRowsAtOnce = reference::Visibility::kBandRows;

/// Lines from the top, whatever row 0 is.
std::string png_of(const scene::Scene& scene, std::vector<Colour> pixels) {
  const scene::Camera& camera = *scene.camera;
  if (scene.conventions.rows != scene::Rows::kTopFirst) {
    const auto line = [&](std::int64_t j) { return pixels.begin() + j * camera.width; };
    for (std::int64_t low = 0, high = camera.height - 1; low < high; ++low, --high) {
      std::swap_ranges(line(low), line(low + 1), line(high));
    }
  }
  return png_bytes(camera.width, camera.height, pixels);
}

Colour pixel_colour(std::int32_t sphere) {
  if (sphere == kFailedPixel) return kFailedColour;
  if (sphere == kSomePixel) return kHitColour;
  return sphere == kNoSphere ? kBackground : sphere_colour(static_cast<std::size_t>(sphere));
}

/// Which spheres are seen by how many pixels, as a picture's legend.
ScenePicture picture_of(const scene::Scene& scene, const std::vector<std::int32_t>& seen,
                        PictureKind kind, std::string candidate) {
  constexpr std::size_t kMostEntries = 24;
  ScenePicture picture{kind, std::move(candidate), {}, {}};
  std::vector<Colour> pixels(seen.size());
  std::transform(seen.begin(), seen.end(), pixels.begin(), pixel_colour);
  std::map<std::int32_t, std::uint64_t> counts;
  for (const std::int32_t sphere : seen) ++counts[sphere];
  for (const auto& [sphere, count] : counts) {
    if (picture.legend.size() == kMostEntries) break;
    picture.legend.push_back({pixel_colour(sphere),
                              sphere == kFailedPixel ? "no answer"
                              : sphere == kSomePixel ? "a sphere, not told which"
                              : sphere == kNoSphere  ? "no sphere"
                                                     : fmt::format("sphere {}", sphere),
                              count});
  }
  picture.png = png_of(scene, std::move(pixels));
  return picture;
}

/// What a candidate answers on rows of pixels.
void answer(const scene::Scene& scene, const properties::Candidate& candidate, std::int64_t j,
            std::span<std::int32_t> rows) {
  properties::Case some = {scene, {}};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto index = static_cast<std::int64_t>(k);
    some.pixels.push_back({index % scene.camera->width, j + index / scene.camera->width});
  }
  try {
    properties::Trial trial(some, candidate);
    const auto& nearest = trial.nearest();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      rows[k] = nearest[k] ? static_cast<std::int32_t>(*nearest[k]) : kNoSphere;
    }
  } catch (const std::runtime_error&) {
    std::fill(rows.begin(), rows.end(), kFailedPixel);
  }
}

/// Of a picture that is drawn as a whole no s is known.
std::vector<LegendEntry> error_legend(const ErrorCounts& counts, bool is_drawn,
                                      std::uint64_t pixels) {
  std::vector<LegendEntry> legend;
  for (const std::uint64_t some : counts.pixels) pixels -= some;
  for (const std::uint64_t some : counts.wrong) pixels -= some;
  if (is_drawn) {
    legend.push_back({kErrorSteps.front().colour, "as it should be", counts.pixels.front()});
  } else {
    legend.push_back({kBackground, "rightly no sphere", pixels});
  }
  for (std::size_t k = 0; k < kErrorSteps.size() && !is_drawn; ++k) {
    const bool is_last = k + 1 == kErrorSteps.size();
    legend.push_back({kErrorSteps[k].colour,
                      is_last ? fmt::format("s off by more than {} ulp", kErrorSteps[k - 1].at_most)
                              : fmt::format("s off by up to {} ulp", kErrorSteps[k].at_most),
                      k < counts.pixels.size() ? counts.pixels[k] : 0});
  }
  for (std::size_t k = 0; k < kWrongColours.size(); ++k) {
    const auto standing = static_cast<properties::Standing>(k);
    if (counts.wrong[k] == 0 && standing != properties::Standing::kDefect) continue;
    legend.push_back({kWrongColours[k], fmt::format("wrong class or sphere: {}", name(standing)),
                      counts.wrong[k]});
  }
  return legend;
}

}  // namespace

SceneImages images_of(const scene::Scene& scene, const std::vector<CandidateMaker>& candidates,
                      const properties::RunControl& control) {
  const scene::Camera& camera = *scene.camera;
  const auto count = static_cast<std::size_t>(camera.width * camera.height);
  const reference::Visibility visibility(
      scene, scene::plan_scene(scene, scene.conventions, scene::Wanted::kNearest));
  struct Shown {
    properties::Candidate candidate;
    std::unique_ptr<Painter> painter;
    std::vector<std::int32_t> answered;
    std::vector<Colour> errors;
    ErrorCounts counts;
  };
  std::vector<Shown> shown;
  for (const CandidateMaker& maker : candidates) {
    properties::Candidate candidate = maker();
    const bool is_drawn = candidate.image != nullptr;
    auto painter = is_drawn ? drawn_error_painter(scene, candidate) : error_painter(scene, maker);
    auto answered = is_drawn ? drawn_picture(scene, candidate) : std::vector<std::int32_t>(count);
    shown.push_back({std::move(candidate),
                     std::move(painter),
                     std::move(answered),
                     std::vector<Colour>(count),
                     {}});
  }
  SceneImages images;
  std::vector<std::int32_t> seen(count);
  for (std::int64_t j = 0; j < camera.height; j += kRowsAtOnce) {
    if (control.interrupted()) return {};
    SeenBand band;
    band.j_begin = j;
    band.j_end = std::min(j + kRowsAtOnce, camera.height);
    const auto first = static_cast<std::size_t>(j * camera.width);
    band.sphere.resize(static_cast<std::size_t>((band.j_end - j) * camera.width));
    visibility.nearest(band.j_begin, band.j_end, {band.sphere, {}, {}, {}, {}});
    std::copy(band.sphere.begin(), band.sphere.end(), seen.begin() + j * camera.width);
    for (Shown& one : shown) {
      if (!one.candidate.image) {
        answer(scene, one.candidate, j, std::span(one.answered).subspan(first, band.sphere.size()));
      }
      one.painter->paint(band, std::span(one.errors).subspan(first, band.sphere.size()),
                         one.counts);
    }
  }
  for (const std::int32_t sphere : seen) {
    if (images.seen.empty() || images.seen.back().sphere != sphere) {
      images.seen.push_back({0, sphere});
    }
    ++images.seen.back().pixels;
  }
  images.pictures.push_back(picture_of(scene, seen, PictureKind::kCertified, {}));
  for (Shown& one : shown) {
    images.pictures.push_back(
        picture_of(scene, one.answered, PictureKind::kAnswered, one.candidate.name));
    images.pictures.push_back({PictureKind::kError, one.candidate.name,
                               png_of(scene, std::move(one.errors)),
                               error_legend(one.counts, one.candidate.image != nullptr, count)});
  }
  return images;
}

}  // namespace raycheck::tools
