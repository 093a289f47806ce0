#include "tools/view/pictures/pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "properties/laws/law.h"
#include "properties/trial.h"
#include "reference/visibility/visibility.h"
#include "tools/report/picture_file.h"
#include "tools/report/spelling.h"
#include "tools/run/threads.h"

namespace raycheck::tools {
namespace {

using reference::kNoSphere;

/// The values of pixels in a candidate's picture that are neither a known sphere nor background.
constexpr std::int32_t kFailedPixel = -2;  ///< The candidate failed.
constexpr std::int32_t kSomePixel = -3;    ///< An unknown sphere.

constexpr Colour kFailedColour = {128, 128, 128};

/// The number of rows that are decided and painted at a time; interrupts are checked in between.
constexpr std::int64_t kRowsAtOnce = reference::Visibility::kBandRows;

/// The picture as PNG, from the top line on, whichever row is row 0.
std::string png_of(const scene::Scene& scene, std::vector<Colour> pixels) {
  const scene::Camera& camera = *scene.camera;
  if (scene.conventions.rows != scene::Rows::kTopFirst) flip_lines(pixels, camera.width);
  return png_bytes(camera.width, camera.height, pixels);
}

Colour pixel_colour(std::int32_t sphere) {
  if (sphere == kFailedPixel) return kFailedColour;
  if (sphere == kSomePixel) return kHitColour;
  return sphere == kNoSphere ? kBackground : sphere_colour(static_cast<std::size_t>(sphere));
}

Json entry_json(const Colour& colour, const std::string& text, std::uint64_t pixels) {
  return {{"colour", "#" + hex(colour)}, {"text", text}, {"pixels", pixels}};
}

Json picture_json(const char* kind, const std::string& name, const std::string& png, Json legend) {
  return {{"kind", kind},
          {"name", name},
          {"png", data_address("image/png", png)},
          {"legend", std::move(legend)}};
}

/// A picture of the nearest spheres of all pixels.
Json picture_of(const scene::Scene& scene, const std::vector<std::int32_t>& seen, const char* kind,
                const std::string& name) {
  constexpr std::size_t kMostEntries = 24;
  std::vector<Colour> pixels(seen.size());
  std::ranges::transform(seen, pixels.begin(), pixel_colour);
  std::map<std::int32_t, std::uint64_t> counts;
  for (const std::int32_t sphere : seen) ++counts[sphere];
  Json legend = Json::array();
  for (const auto& [sphere, count] : counts) {
    if (legend.size() == kMostEntries) break;
    legend.push_back(entry_json(pixel_colour(sphere),
                                sphere == kFailedPixel ? "no answer"
                                : sphere == kSomePixel ? "an unknown sphere"
                                : sphere == kNoSphere  ? "no sphere"
                                                       : fmt::format("sphere {}", sphere),
                                count));
  }
  return picture_json(kind, name, png_of(scene, std::move(pixels)), std::move(legend));
}

/// The number of pixels judged at a time; so few that a verdict keeps every discrepancy.
constexpr std::size_t kPixelsAtOnce = 512;
static_assert(kPixelsAtOnce <= properties::kKeptDiscrepancies);

std::int32_t pixel_of(const std::optional<std::size_t>& pixel) {
  return !pixel                           ? reference::kNoSphere
         : *pixel >= properties::kUnclear ? kSomePixel
                                          : static_cast<std::int32_t>(*pixel);
}

void paint_chunk(const properties::Case& chunk, const properties::Candidate& candidate,
                 std::span<Colour> pixels, ErrorCounts& errors) {
  std::ranges::fill(pixels, kErrorSteps.front().colour);
  std::vector<bool> is_wrong(pixels.size());
  const auto mark = [&](std::size_t k, properties::Standing standing) {
    if (is_wrong[k]) return;
    is_wrong[k] = true;
    pixels[k] = kWrongColours[static_cast<std::size_t>(standing)];
    ++errors.wrong[static_cast<std::size_t>(standing)];
  };
  properties::Trial trial(chunk, candidate);
  const std::size_t before = trial.place(0).ray;  // The image's pixels before this chunk.
  for (const properties::Law* law : properties::laws_that(
           [](const properties::Law& one) { return one.per == properties::Per::kImage; })) {
    const properties::Verdict verdict = properties::apply(*law, trial);
    for (const properties::Discrepancy& one : verdict.worst(kPixelsAtOnce)) {
      if (one.wrong == properties::Wrong::kFailed) {
        for (std::size_t k = 0; k < pixels.size(); ++k) mark(k, one.excuse.standing());
        if (errors.failed == 0) errors.first_failure = one.what;
        errors.failed += pixels.size();
      } else {
        mark(one.place.ray - before, one.excuse.standing());
      }
    }
  }
  errors.pixels.front() += static_cast<std::uint64_t>(std::ranges::count(is_wrong, false));
}

/// The pixels of a picture that a candidate draws as a whole, row after row: a sphere, kNoSphere or
/// kSomePixel. If the candidate fails, all are kFailedPixel.
std::vector<std::int32_t> drawn_picture(const scene::Scene& scene,
                                        const properties::Candidate& candidate) {
  const auto count = static_cast<std::size_t>(scene.camera->width * scene.camera->height);
  std::vector<std::int32_t> picture(count, kFailedPixel);
  try {
    const properties::ImageAnswer answer =
        candidate.image(scene, candidate.declared.over(scene.conventions));
    if (answer.size() == count) {
      std::ranges::transform(answer, picture.begin(), pixel_of);
    }
  } catch (const properties::NoAnswer&) {  // the findings report the failure
  }
  return picture;
}

/// Paints pixels that laws about images find wrong by their standing, and all others as right;
/// counts both. Right pixels count under the first error.
Painter drawn_error_painter(const scene::Scene& scene, properties::Candidate candidate) {
  return [&scene, judged = std::move(candidate)](const SeenBand& band, std::span<Colour> pixels,
                                                 ErrorCounts& errors) {
    errors.pixels.resize(kErrorSteps.size());
    for (std::size_t first = 0; first < pixels.size(); first += kPixelsAtOnce) {
      const std::size_t end = std::min(first + kPixelsAtOnce, pixels.size());
      paint_chunk({scene, pixels_of_rows(scene, band.j_begin, first, end)}, judged,
                  pixels.subspan(first, end - first), errors);
    }
  };
}

void answer(const scene::Scene& scene, const properties::Candidate& candidate, std::int64_t j,
            std::span<std::int32_t> rows) {
  const properties::Case some = {scene, pixels_of_rows(scene, j, 0, rows.size())};
  try {
    properties::Trial trial(some, candidate);
    const auto& nearest = trial.nearest();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      rows[k] = nearest[k] ? static_cast<std::int32_t>(*nearest[k]) : kNoSphere;
    }
  } catch (const properties::NoAnswer&) {
    std::ranges::fill(rows, kFailedPixel);
  }
}

/// The legend of a picture of errors. For a picture that is drawn as a whole, s is unknown.
Json error_legend(const ErrorCounts& counts, bool is_drawn, std::uint64_t pixels) {
  Json legend = Json::array();
  for (const std::uint64_t some : counts.pixels) pixels -= some;
  for (const std::uint64_t some : counts.wrong) pixels -= some;
  if (is_drawn) {
    legend.push_back(entry_json(kErrorSteps.front().colour, "correct", counts.pixels.front()));
  } else {
    legend.push_back(entry_json(kBackground, "no sphere, correct", pixels));
  }
  for (std::size_t k = 0; k < kErrorSteps.size() && !is_drawn; ++k) {
    const bool is_last = k + 1 == kErrorSteps.size();
    legend.push_back(
        entry_json(kErrorSteps[k].colour,
                   is_last ? fmt::format("s off by more than {} ulp", kErrorSteps[k - 1].at_most)
                           : fmt::format("s off by up to {} ulp", kErrorSteps[k].at_most),
                   k < counts.pixels.size() ? counts.pixels[k] : 0));
  }
  for (std::size_t k = 0; k < kWrongColours.size(); ++k) {
    const auto standing = static_cast<properties::Standing>(k);
    if (counts.wrong[k] == 0 && standing != properties::Standing::kDefect) continue;
    legend.push_back(entry_json(kWrongColours[k],
                                fmt::format("wrong hit class or sphere: {}", name(standing)),
                                counts.wrong[k]));
  }
  return legend;
}

}  // namespace

SceneImages images_of(const scene::Scene& scene, const std::vector<CandidateMaker>& candidates,
                      const properties::RunControl& control) {
  const scene::Camera& camera = *scene.camera;
  const auto count = static_cast<std::size_t>(camera.width * camera.height);
  const reference::Visibility visibility(
      scene, scene::plan_scene(scene, scene.conventions, scene::Wanted::kNearest, {},
                               for_each_on(control)));
  struct Shown {
    properties::Candidate candidate;
    Painter painter;
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
    std::ranges::copy(band.sphere, seen.begin() + j * camera.width);
    for (Shown& one : shown) {
      if (!one.candidate.image) {
        answer(scene, one.candidate, j, std::span(one.answered).subspan(first, band.sphere.size()));
      }
      one.painter(band, std::span(one.errors).subspan(first, band.sphere.size()), one.counts);
    }
  }
  for (const std::int32_t sphere : seen) {
    if (images.seen.empty() || images.seen.back().sphere != sphere) {
      images.seen.push_back({0, sphere});
    }
    ++images.seen.back().pixels;
  }
  images.pictures.push_back(picture_of(scene, seen, "certified", "certified"));
  for (Shown& one : shown) {
    const std::string& name = one.candidate.name;
    images.pictures.push_back(
        picture_of(scene, one.answered, "answered", fmt::format("answers of {}", name)));
    images.pictures.push_back(
        picture_json("error", "errors of " + name, png_of(scene, std::move(one.errors)),
                     error_legend(one.counts, one.candidate.image != nullptr, count)));
  }
  return images;
}

}  // namespace raycheck::tools
