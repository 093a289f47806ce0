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

/// Each call makes a new candidate, whose conventions the scene is shown under.
using CandidateMaker = std::function<properties::Candidate()>;

/// The pictures of a scene: what its pixels see, certified; for each candidate its answers and the
/// error of its s or, for one that draws whole images, its picture and where that is wrong.
/// Domain: a valid scene with a camera, with few enough pixels for memory; candidates that draw
///         images, or make rays from its origin and rank spheres.
struct SceneImages {
  std::vector<ScenePicture> pictures;
  std::vector<SeenRun> seen;
};
SceneImages images_of(const scene::Scene& scene, const std::vector<CandidateMaker>& candidates,
                      const properties::RunControl& control);

/// What a pixel of a candidate's picture shows if it is neither a certain sphere nor nothing.
inline constexpr std::int32_t kFailedPixel = -2;  ///< The candidate failed.
inline constexpr std::int32_t kSomePixel = -3;    ///< A sphere; it cannot be told which.

/// What every pixel shows of a picture that a candidate draws as a whole, row j after row j: a
/// sphere, reference::kNoSphere, kSomePixel, or, if it fails, kFailedPixel everywhere.
/// Domain: a scene with a camera, a candidate that has `image`.
std::vector<std::int32_t> drawn_picture(const scene::Scene& scene,
                                        const properties::Candidate& candidate);

/// Paints pixels that laws about images find wrong by their standing, all others as right, and
/// counts both; right ones count under the first error.
std::unique_ptr<Painter> drawn_error_painter(const scene::Scene& scene,
                                             properties::Candidate candidate);

}  // namespace raycheck::tools
