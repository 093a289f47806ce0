#pragma once

#include <optional>
#include <span>

#include "reference/account/nearby_answer.h"
#include "reference/account/nearby_choice.h"

namespace raycheck::reference {

// The results of right_nearby() for wrong answers where not every root >= 0 counts
// (scene::ValidRoots): t_min and t_max are not inputs, and are taken exactly. A refutation is
// proven, by balls that hold the roots for all inputs within the relative change. Where no end
// matters (below), witnesses are searched for as if every root >= 0 counted; the rest is undecided:
// roots about as far from an end, from a tangent or from each other as the change is wide. An
// answered s outside the interval is refuted: no inputs make it count. Domain: as ExactRay;
// conventions without defects (scene/validate.h).

/// For the answer that a ray misses (empty), or meets a sphere at s.
NearbyAnswer refuted_nearby(const ExactRay& ray, const scene::Sphere& sphere,
                            const Neighbourhood& around, const std::optional<double>& answer);

/// For a claim about the first hit.
NearbyAnswer refuted_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                            const Neighbourhood& around, const FirstMet& claim);

/// Whether, for some inputs of the neighbourhood, another root of one of the spheres may count than
/// if every root >= 0 did.
bool ends_matter_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                        const Neighbourhood& around);

/// The reverse of a given ray, which meets ahead of its origin what the line meets behind it, where
/// all of that counts: inputs close by miss the sphere with both rays or with neither.
std::optional<ExactRay> reversed_behind(const ExactRay& ray, const scene::Sphere& sphere,
                                        const Neighbourhood& around);

/// Whether an answered s lies outside the interval from t_min to t_max. The comparison is exact: of
/// s with t; of s with t r if the ends are in radii; of |direction| s with t if they are scene
/// lengths and the ray is given (for a camera's rays s is a scene length). Domain: s is finite.
bool is_outside(const scene::ValidRoots& valid, const ExactRay& ray, const scene::Sphere& sphere,
                double s);

}  // namespace raycheck::reference
