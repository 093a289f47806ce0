#pragma once

#include <functional>
#include <vector>

#include "properties/candidate.h"
#include "properties/run_control.h"
#include "tools/image/image_paint.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// Makes a new candidate. The scene is shown under its conventions.
using CandidateMaker = std::function<properties::Candidate()>;

/// The pictures of a scene: its certified spheres and, for each candidate, its answers and the
/// errors of s. If a candidate draws whole images: its picture and the wrong pixels.
/// Domain: a
/// valid scene with a camera whose pixels fit in memory; candidates that draw
///         images, or make rays from its origin and rank spheres.
struct SceneImages {
  Json pictures = Json::array();
  std::vector<SeenRun> seen;
};
SceneImages images_of(const scene::Scene& scene, const std::vector<CandidateMaker>& candidates,
                      const properties::RunControl& control);

}  // namespace raycheck::tools
