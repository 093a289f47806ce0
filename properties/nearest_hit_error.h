#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "properties/trial.h"

namespace raycheck::properties {

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
