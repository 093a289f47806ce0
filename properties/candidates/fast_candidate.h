#pragma once

#include <span>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidate.h"

namespace raycheck::properties {

/// A ray method and an intersection method of fast/ as one candidate, "RAYS/INTERSECT". On given
/// rays its bounds and its domain are those of the intersection method. From a camera, the bounds
/// of its rays are added to those of its hits, and lengths must lie in the domains of both methods.
/// `visible` uses a plan with these `items`.
Candidate fast_candidate(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect,
                         const scene::PlanItems& items = {});

/// Convert rays to batches of fast/ and back, and the hits of a batch to answers of a candidate.
fast::Rays batch_of(std::span<const scene::Ray> rays);
std::vector<scene::Ray> rays_of(const fast::Rays& batch);
SphereHits list_of(const fast::Hits& hits);

}  // namespace raycheck::properties
