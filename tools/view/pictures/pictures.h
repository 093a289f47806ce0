#pragma once

#include <functional>
#include <vector>

#include "properties/candidate.h"
#include "properties/run_control.h"
#include "tools/image/image_paint.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// Each call makes a new candidate, whose conventions the scene is shown under.
using CandidateMaker = std::function<properties::Candidate()>;

/// The pictures of a scene: its certified spheres; for each candidate its answers and the error of
/// its s or, if it draws whole images, its picture and the wrong pixels.
/// Domain: a valid scene with a camera, with few enough pixels for memory; candidates that draw
///         images, or make rays from its origin and rank spheres.
struct SceneImages {
  Json pictures = Json::array();
  std::vector<SeenRun> seen;
};
SceneImages images_of(const scene::Scene& scene, const std::vector<CandidateMaker>& candidates,
                      const properties::RunControl& control);

}  // namespace raycheck::tools
