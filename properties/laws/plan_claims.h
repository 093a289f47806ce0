#pragma once

// What a candidate's plans claim about a scene, and the pixels at which that is tested. Internal to
// properties/.

#include <array>
#include <cstddef>
#include <vector>

#include "properties/trial.h"
#include "scene/plan/plan.h"

namespace raycheck::properties {

inline constexpr std::array kEveryWanted = {scene::Wanted::kClass, scene::Wanted::kParameter,
                                            scene::Wanted::kPoint, scene::Wanted::kNearest};

/// How many pixels along each border of a rectangle are tried, at most.
inline constexpr std::int64_t kMostOfBorder = 64;
/// How many rows, and columns, inside a rectangle, at most.
inline constexpr std::int64_t kMostInside = 5;

/// What one plan says about one sphere, and what the plan was made for.
struct PlanStatement {
  scene::Wanted wanted;
  const scene::ScenePlan* plan;
  std::size_t sphere;

  const scene::SpherePlan& said() const { return plan->spheres[sphere]; }
};

/// The plans of a candidate for one scene, whatever is wanted of it. They choose where the truth is
/// computed, and do not influence it.
/// Domain: a scene with a camera, a candidate that plans. Throws std::runtime_error when a plan
///         does not speak of every sphere.
class PlanStatements {
 public:
  explicit PlanStatements(const Trial& trial);

  scene::PixelRectangle image() const { return {0, camera_.width, 0, camera_.height}; }

  /// The distinct statements about a sphere.
  std::vector<PlanStatement> of(std::size_t sphere) const;

  /// Pixels where a sphere is or nearly is, according to the plans: in its rectangle in any plan
  /// that has one, otherwise in the image. Plus all pixels of the case.
  std::vector<scene::Pixel> inside(const PlanStatement& statement) const;

  /// Pixels of the image just outside a sphere's rectangle, including those next to where its
  /// silhouette touches it. Plus those of the case that are outside.
  std::vector<scene::Pixel> outside(const PlanStatement& statement) const;

 private:
  const std::vector<scene::Pixel>& pixels_;
  const scene::Camera& camera_;
  std::vector<scene::ScenePlan> plans_;
};

}  // namespace raycheck::properties
