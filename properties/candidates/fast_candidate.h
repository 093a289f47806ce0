#pragma once

#include <span>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidate.h"

namespace raycheck::properties {

/// How much a hit's bound grows where its ray comes from a camera, in multiples of the ray's bound:
/// the ray's origin and direction are each off by that much, and hence s and Q, in proportion to
/// their condition numbers; audited by the campaigns.
inline constexpr double kRayShare = 1;
double inherited_bound(const fast::PixelRayMethod& rays);

/// What the residuals' bounds gain over the point's: a point rounded to doubles is off by up to
/// u |Q|, which is half the residual's condition number, (|Q| + |C| + |L| + r)/r or over s |D|, in
/// units of u of r or s |D|.
inline constexpr double kRoundedPointResidual = kModerateCondition / 2;

/// A ray method and an intersection method of fast/ as one candidate, "RAYS/INTERSECT". On given
/// rays it promises what the intersection method does, in that method's domain; end to end from a
/// camera the bounds of its hits are larger by inherited_bound(), in both methods' domains.
/// `visible` uses a plan with these `items`.
Candidate fast_candidate(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect,
                         const scene::PlanItems& items = {});

/// Rays as fast/ takes them, and back; the hits of a batch as candidates answer.
fast::Rays batch_of(std::span<const scene::Ray> rays);
std::vector<scene::Ray> rays_of(const fast::Rays& batch);
SphereHits list_of(const fast::Hits& hits);

}  // namespace raycheck::properties
