#pragma once

#include <functional>

#include "properties/run_control.h"
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

}  // namespace raycheck::tools
