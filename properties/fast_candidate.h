#ifndef RAYCHECK_PROPERTIES_FAST_CANDIDATE_H_
#define RAYCHECK_PROPERTIES_FAST_CANDIDATE_H_

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidate.h"

namespace raycheck::properties {

/// A ray method and an intersection method of fast/ as one candidate, "RAYS/INTERSECT".
Candidate fast_candidate(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect);

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_FAST_CANDIDATE_H_
