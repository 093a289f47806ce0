#pragma once

// Judges which of several spheres a ray meets first: compares the candidate's choice with the exact
// one.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "properties/trial.h"
#include "reference/account/nearby_choice.h"

namespace raycheck::properties {

using Index = std::optional<std::size_t>;

/// The candidate's sphere (or kSomeSphere) and the exact one, as indices in the scene.
struct Choice {
  std::size_t ray;
  Index got;
  const std::optional<NearestSphere>& exact;
  const char* what = "sphere index";  ///< In discrepancies.
  bool is_first_of_ties = false;      ///< Whether the candidate promises the first sphere of a tie.
};
bool is_right(const Choice& choice);
Wrong wrong_of(const Choice& choice);

/// Whether some point of a pixel's square may show what the picture shows there, for inputs within
/// a relative change (reference::may_be_right_in_pixel).
bool may_be_elsewhere_in_pixel(const ExactRay& ray, std::span<const Sphere> spheres,
                               const Conventions& conventions, Index got, double change);

/// The excuse for a wrong sphere: inputs within this relative change for which the ray meets that
/// sphere first.
Excuse excuse(Trial& trial, std::size_t ray, Index got, double change);

/// Counts a choice, and adds a discrepancy if it is wrong.
void judge_choice(Trial& trial, Verdict& verdict, const Choice& choice, Expected expected,
                  const std::function<Excuse()>& excuse);

/// The number of spheres that each ray of a case meets.
struct SpheresMet {
  std::vector<std::uint32_t> count;  ///< The number of spheres that each ray meets.
  /// By ray: whether it is a tangent, and tangents are not judged; or whether it starts inside a
  /// sphere, and the candidate declares that its hit is not a root that counts.
  std::vector<bool> is_unjudged;
  bool some_start_inside = false;  ///< Whether a ray is not judged for the second reason.

  Expected expected(std::size_t ray) const {
    return count[ray] == 0   ? Expected::kNoSphere
           : count[ray] == 1 ? Expected::kOnlySphere
                             : Expected::kNearestOfSeveral;
  }
};
SpheresMet spheres_met(Trial& trial);

/// How a candidate's nearest hit of a ray compares with the exact one.
struct NearestHitError {
  Wrong wrong = Wrong::kNot;
  /// The standing of a wrong answer; outside the stated domain and at unjudged tangents,
  /// kNotJudged.
  Standing standing = Standing::kDefect;
  std::optional<double> ulp;  ///< The error of s; empty if the sphere is wrong, or both miss.
};

/// Compares a candidate's nearest hits with the exact ones, as the laws `nearest-sphere` and
/// `parameter` do, ray by ray.
/// Shape:  `seen`, the exact nearest sphere of each ray of the trial's case
///         (reference/visibility/visibility.h) -> one answer a ray.
/// Units:  ulp of the exact s, in the format that the trial judges in.
/// Domain: a candidate that makes rays from the trial's origin and ranks spheres.
/// Error:  an upper bound, from an enclosure of s.
std::vector<NearestHitError> nearest_hit_errors(Trial& trial, std::span<const std::int32_t> seen);

}  // namespace raycheck::properties
