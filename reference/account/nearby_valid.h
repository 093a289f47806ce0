#pragma once

#include <optional>
#include <span>

#include "reference/account/nearby_answer.h"
#include "reference/account/nearby_choice.h"

namespace raycheck::reference {

// The results of right_nearby() for wrong answers if not every root >= 0 counts
// (scene::ValidRoots). t_min and t_max are exact and do not change. A refutation is proved by balls
// that contain the roots for all inputs within the relative change. If no end matters
// (ends_matter_nearby()), witnesses are searched for as if every root >= 0 counted. Undecided are
// roots whose distance from an end, from a tangent or from each other is about as large as the
// change. An answered s outside the interval is refuted, since no inputs make it count. Domain:
// that of ExactRay; conventions without defects (scene/validate.h).

/// The result for the answer that a ray misses a sphere (empty), or meets it at s.
NearbyAnswer refuted_nearby(const ExactRay& ray, const scene::Sphere& sphere,
                            const Neighbourhood& around, const std::optional<double>& answer);

/// The result for a claim about the first hit.
NearbyAnswer refuted_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                            const Neighbourhood& around, const FirstMet& claim);

/// Whether, for some inputs of the neighbourhood, the roots of a sphere that count may differ from
/// those >= 0.
bool ends_matter_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                        const Neighbourhood& around);

/// A given ray with the opposite direction, which meets ahead of its origin the sphere that the
/// line meets behind it. Empty unless the sphere is behind and all roots there count. Inputs close
/// by miss the sphere with both rays or with neither.
std::optional<ExactRay> reversed_behind(const ExactRay& ray, const scene::Sphere& sphere,
                                        const Neighbourhood& around);

/// Whether an answered s lies outside the interval from t_min to t_max, decided exactly. s is
/// compared with an end t, or with t r if the ends are in radii. If the ends are scene lengths and
/// the ray is given, |direction| s is compared with t; for a camera's ray, s is a scene length.
/// Domain: s is finite.
bool is_outside(const scene::ValidRoots& valid, const ExactRay& ray, const scene::Sphere& sphere,
                double s);

}  // namespace raycheck::reference
