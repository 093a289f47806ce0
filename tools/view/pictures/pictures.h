#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "properties/candidate.h"
#include "properties/run_control.h"
#include "tools/image/image_paint.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// A candidate of its own for each call, under whose conventions a scene is shown.
using CandidateMaker = std::function<properties::Candidate()>;

/// The pictures of a scene: what its pixels see, certified; for each candidate what it answers and
/// how far its s is off, or, of one that draws whole images, what it shows and where that is wrong.
/// Domain: a valid scene with a camera of few enough pixels to be held at once; candidates that
///         draw images, or make rays from its origin and rank spheres.
struct SceneImages {
  std::vector<ScenePicture> pictures;
  std::vector<SeenRun> seen;
};
SceneImages images_of(const scene::Scene& scene, const std::vector<CandidateMaker>& candidates,
                      const properties::RunControl& control);

/// What a pixel of a candidate's picture shows where that is no sphere and not nothing.
inline constexpr std::int32_t kFailedPixel = -2;  ///< It has not answered.
inline constexpr std::int32_t kSomePixel = -3;    ///< A sphere; it cannot be told which.

/// What every pixel of a picture shows that a candidate draws as a whole, row j after row j: a
/// sphere, reference::kNoSphere, kSomePixel, or, where it fails, kFailedPixel everywhere.
/// Domain: a scene with a camera, a candidate that has `image`.
std::vector<std::int32_t> drawn_picture(const scene::Scene& scene,
                                        const properties::Candidate& candidate);

/// Paints the pixels that the laws about images hold against such a candidate by their standing,
/// all others as right ones, and counts both; those that are right under the first error.
std::unique_ptr<Painter> drawn_error_painter(const scene::Scene& scene,
                                             properties::Candidate candidate);

}  // namespace raycheck::tools
