#pragma once

// Which of several spheres a ray meets first, for a candidate and exactly.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "properties/trial.h"

namespace raycheck::properties {

using Index = std::optional<std::size_t>;

/// The candidate's sphere (or kSomeSphere) and the exact one, both by the scene's order.
struct Choice {
  std::size_t ray;
  Index got;
  const std::optional<reference::NearestSphere>& exact;
  const char* what = "sphere index";  ///< In discrepancies.
  bool is_first_of_ties = false;      ///< Whether the candidate promises that.
};
bool is_right(const Choice& choice);
Wrong wrong_of(const Choice& choice);

/// The excuse for a sphere that is not the one the ray meets first: inputs within a relative change
/// for which it is.
Excuse excuse(Trial& trial, std::size_t ray, Index got, double change);

/// Counts a choice, and adds a discrepancy when it is wrong.
void judge_choice(Trial& trial, Verdict& verdict, const Choice& choice, Expected expected,
                  const std::function<Excuse()>& excuse);

/// What the rays of a case meet.
struct SpheresMet {
  std::vector<std::uint32_t> count;  ///< Spheres met, by ray.
  std::vector<bool> is_unjudged;     ///< Rays that touch one where tangents are not judged.

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
  /// Of what is wrong: not judged outside the stated domain, and at tangents that are not.
  Standing standing = Standing::kDefect;
  std::optional<double> ulp;  ///< The error of s; empty where it is wrong, or both see nothing.
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
