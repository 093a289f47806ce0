#pragma once

// Plans several spheres at once, in vectors as wide as the machine's. Internal to scene/plan.

#include <cstddef>
#include <span>

#include "scene/plan/plan.h"

namespace raycheck::scene {

/// The terms that the spheres of a scene share. Lengths are in the unit of EyeSphere.
struct PlanTerms {
  const EyeSpace& eye;
  const PlanItems& items;
  bool is_forward;   ///< Rays go along W.
  bool from_pixels;  ///< Rays start on the image plane.
  bool far_root_may_count;
  double width, height;
  Bounds near, across, along;  ///< The image plane.
  Bounds start;                ///< Where rays start, measured along W, or -W if they go so.
  Bounds ahead;                ///< Where the image plane is, measured as `start`; scaled as near().
};

/// The plans of several spheres, lane by lane.
struct PlannedNumbers {
  static constexpr std::size_t kMostLanes = 32;

  alignas(64) double low[6][kMostLanes];  ///< The bounds of EyeSphere.
  double high[6][kMostLanes];
  double nearest_distance[kMostLanes];
  double sides[4][kMostLanes];
  // One bit per lane: no part of the sphere is behind; no origin is inside; all of the sphere is
  // behind; no pixel's ray meets it.
  unsigned in_front, origin_outside, behind, none;
};

/// Plans each sphere independently, before hidden spheres are left out.
void plan_each(const PlanTerms& terms, std::span<const Sphere> spheres, std::span<SpherePlan> plans,
               std::span<double> nearest_distance);

}  // namespace raycheck::scene
