#ifndef RAYCHECK_TOOLS_PEERS_PEERS_H_
#define RAYCHECK_TOOLS_PEERS_PEERS_H_

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

// The bounds, in ulp of s and u of |Q|: those who take squares of lengths apart share one.
inline constexpr double kSquaresMaxUlp = 512;
/// In the ulp and u of double precision, of arithmetic that has 29 bits less.
inline constexpr double kEmbreeMaxUlp = 96 * 0x1p29;
/// 96 bits, rounded once; Q is computed in doubles.
inline constexpr double kCoreMaxUlp = 0.5 + 0x1p-30;
inline constexpr double kCoreMaxPointUlp = 96;

/// The methods whose libraries were there when raycheck was built, in the order of reports.
std::span<const fast::IntersectMethod* const> peers();

// What peers() chooses from; those whose library is missing are not defined.
extern const fast::IntersectMethod kGlm;
extern const fast::IntersectMethod kBoost;
extern const fast::IntersectMethod kGsl;
extern const fast::IntersectMethod kEmbree;
extern const fast::IntersectMethod kVecgeom;
extern const fast::IntersectMethod kCore;

/// s by the `root` convention from the two roots that a solver returns, the smaller first.
inline std::optional<double> choose(const std::pair<double, double>& roots, scene::Root root) {
  if (roots.first >= 0) return roots.first;
  if (root == scene::Root::kNearest && roots.second >= 0) return roots.second;
  return std::nullopt;
}

}  // namespace raycheck::peers

#endif  // RAYCHECK_TOOLS_PEERS_PEERS_H_
