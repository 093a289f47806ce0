#pragma once

// Intersection methods of other libraries, to be compared with those of fast/. Each asks what its
// library documents (its contract) and answers by the conventions that its library fixes; nothing
// is done on top of a library's answer but to choose among the roots that it returns.

#include <optional>
#include <span>
#include <utility>

#include "fast/intersect.h"

namespace raycheck::peers {

/// The bounds hold for spheres that are up to this many radii away; the others' squares cancel.
inline constexpr double kNearbyRadii = 4;

/// The bound of those who take squares of lengths apart, in ulp of s and u of |Q|.
inline constexpr double kSquaresMaxUlp = 512;

/// The methods whose libraries were there when raycheck was built, in the order of CMakeLists.txt.
std::span<const fast::IntersectMethod* const> peers();

/// s by the `root` convention from the two roots that a solver returns, the smaller first.
inline std::optional<double> choose(const std::pair<double, double>& roots, scene::Root root) {
  if (roots.first >= 0) return roots.first;
  if (root == scene::Root::kNearest && roots.second >= 0) return roots.second;
  return std::nullopt;
}

}  // namespace raycheck::peers
