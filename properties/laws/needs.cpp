#include "properties/laws/needs.h"

#include <algorithm>
#include <iterator>

namespace raycheck::properties {
namespace {

struct Need {
  Needs of;  ///< It is one of each of these.
  bool (*is_met)(const Trial&);
  std::string_view reason;    ///< Why a law is left out if it is not met.
  bool is_of_scenes = false;  ///< Rather than of candidates.
};

bool has_camera(const Trial& trial) { return trial.scene().camera.has_value(); }

/// Whether a candidate has one of its functions.
template <auto Functions::*function>
bool has(const Trial& trial) {
  return static_cast<bool>(trial.candidate().*function);
}

/// In the order of checking: no image has a size where there is no camera.
constexpr Need kNeeds[] = {
    {Needs::kImage, has<&Functions::image>, "the candidate makes no images"},
    {Needs::kMadeRays, has_camera, "the rays are given, not made from a camera", true},
    {kOfCameras, has_camera, "the scene has no camera", true},
    {Needs::kFrame, has<&Functions::frame>, "the candidate gives no frame"},
    {Needs::kPixelPoints, has<&Functions::pixel_points>, "the candidate gives no pixel points"},
    {Needs::kBothOrigins,
     [](const Trial& trial) {
       return has<&Functions::pixel_rays>(trial) && has<&Functions::focal_rays>(trial);
     },
     "the candidate has rays from one origin only"},
    {Needs::kIntersect, has<&Functions::intersect>, "the candidate intersects nothing"},
    {Needs::kEither | Needs::kParameters | Needs::kPoints,
     [](const Trial& trial) { return trial.candidate().returns != Returns::kClass; },
     "the candidate says hit or miss, and no more"},
    {Needs::kParameters,
     [](const Trial& trial) { return gives_parameter(trial.candidate().returns); },
     "the candidate returns points, and no s"},
    {Needs::kPoints, [](const Trial& trial) { return gives_point(trial.candidate().returns); },
     "the candidate returns s, and no points"},
    {Needs::kNearest, has<&Functions::nearest>,
     "the candidate does not tell which sphere a ray meets first"},
    {Needs::kVisible, has<&Functions::visible>, "the candidate sees nothing"},
    {Needs::kPlan, has<&Functions::plan>, "the candidate plans nothing"},
    {Needs::kRefusals, [](const Trial& trial) { return trial.candidate().refuses; },
     "the candidate is never given invalid input"},
    {Needs::kImage,
     [](const Trial& trial) {
       const scene::Camera& camera = *trial.scene().camera;
       return camera.width <= trial.candidate().most_image_pixels / camera.height;
     },
     "the image is larger than the candidate makes"},
    {Needs::kSpheres, [](const Trial& trial) { return !trial.scene().spheres.empty(); },
     "the scene has no sphere", true},
    {Needs::kVisible,
     [](const Trial& trial) {
       const scene::Camera& camera = *trial.scene().camera;
       return std::max(camera.width, camera.height) <= trial.candidate().most_visible_across;
     },
     "the image is larger than the candidate sees"},
    {Needs::kRays | Needs::kMadeRays, [](const Trial& trial) { return trial.has_rays(); },
     "the candidate makes no rays from this origin"},
    {Needs::kSeveralSpheres, [](const Trial& trial) { return trial.scene().spheres.size() > 1; },
     "the scene has one sphere: its class says it all", true},
};

}  // namespace

std::string_view what_is_missing(Needs needs, const Trial& trial) {
  for (const Need& need : kNeeds) {
    if (needs_any(needs, need.of) && !need.is_met(trial)) return need.reason;
  }
  return {};
}

bool scene_suits(Needs needs, const Trial& trial) {
  return std::all_of(std::begin(kNeeds), std::end(kNeeds), [&](const Need& need) {
    return !need.is_of_scenes || !needs_any(needs, need.of) || need.is_met(trial);
  });
}

}  // namespace raycheck::properties
