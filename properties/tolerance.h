#pragma once

// The tolerances that a candidate declares.

#include "contract/declarations.h"
#include "reference/exact_ray.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// A ray and a sphere that may both change by a relative change, as by a candidate's roundings.
struct ChangedPair {
  const reference::ExactRay& ray;
  const scene::Sphere& sphere;
  double relative_change;
};

/// The first of these tolerances within which a ray and a sphere lie; 0 if there is none. Of a hit
/// at s, or at a point, it must be as near to the surface, too.
/// Error: what enclosures leave undecided counts as within.
double tolerance_of(const contract::Tolerances& declared, const ChangedPair& pair);
double tolerance_of(const contract::Tolerances& declared, const ChangedPair& pair, double s);
double tolerance_of(const contract::Tolerances& declared, const ChangedPair& pair,
                    const scene::Point3& point);

}  // namespace raycheck::properties
