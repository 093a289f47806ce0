#pragma once

#include <span>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidate.h"

namespace raycheck::properties {

/// A ray method and an intersection method of fast/ as one candidate, "RAYS/INTERSECT". On given
/// rays it promises what the intersection method does, in that method's domain; end to end from a
/// camera the bounds of its hits are larger by those of its rays, in both methods' domains.
/// `visible` uses a plan with these `items`.
Candidate fast_candidate(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect,
                         const scene::PlanItems& items = {});

/// Rays as fast/ takes them, and back; the hits of a batch as candidates answer.
fast::Rays batch_of(std::span<const scene::Ray> rays);
std::vector<scene::Ray> rays_of(const fast::Rays& batch);
SphereHits list_of(const fast::Hits& hits);

}  // namespace raycheck::properties
