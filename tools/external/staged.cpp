#include "tools/external/staged.h"

#include <memory>

#include "tools/external/candidate_spec.h"

namespace raycheck::tools {

std::vector<StagedMethod> staged(const External& external) {
  if (external.renderer) {
    throw CandidateError("it draws pictures; what is asked here is single answers", {},
                         external.name);
  }
  const Layers& layers = external.program.layers;
  const bool is_kept = layers.own_user || layers.seccomp || layers.landlock || layers.bubblewrap;
  const auto other = std::make_shared<const OtherMethod>(
      OtherMethod{external.name, external.program.layers.text(), candidate_of(external.bounds).name,
                  [external] { return external_candidate(external); }, external.precision,
                  is_kept ? "" : external.library.string(), is_kept});
  const auto offers = [&](const char* function) {
    return external.introduction.functions.contains(function);
  };
  std::vector<StagedMethod> methods;
  const auto& [rays, intersect] = external.bounds;
  if (offers("frame") || offers("pixel_point") || offers("pixel_ray") || offers("focal_ray")) {
    methods.push_back({properties::Stage::kRays, rays, intersect, other});
  }
  if (offers("intersect")) {
    methods.push_back({properties::Stage::kIntersection, rays, intersect, other});
  }
  if (methods.empty()) {
    throw CandidateError("it makes no rays and intersects nothing", {}, external.name);
  }
  return methods;
}

}  // namespace raycheck::tools
