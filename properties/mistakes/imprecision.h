#pragma once

// The answers that a correct formula may give with its roundings: several, if roundings decide.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "properties/candidate.h"

namespace raycheck::properties {

/// How d^2 is computed, from the smallest rounding errors to the largest.
enum class Arithmetic {
  kDifference,        ///< In doubles, a difference that cancels: r^2 - (|T|^2 - v^2), b^2 - 4ac.
  kExpanded,          ///< In doubles, with |T|^2 = |C|^2 - 2 L . C + |L|^2.
  kSingle,            ///< In floats, r^2 - |T x D|^2 or another form that does not cancel.
  kSingleDifference,  ///< In floats, as a difference that cancels.
  kSingleExpanded,    ///< In floats, with |T|^2 expanded.
  kProduct            ///< In doubles, r^2 - |T x D|^2: no mistake.
};
/// Those that are mistakes and show in pictures.
inline constexpr std::array<Arithmetic, 3> kArithmetics = {
    Arithmetic::kDifference, Arithmetic::kSingle, Arithmetic::kSingleDifference};

/// The number of roundings, each of a share u of a term, between the numbers of a scene and d^2: 5
/// in |T|^2, 15 in v^2 (T, D, their product and the square), and those of r^2 and the differences.
inline constexpr double kRoundings = 24;

/// The hits of a ray and a sphere that a formula may find: some s, a miss or either.
struct PossibleHit {
  bool is_possible = false, is_certain = false;
  double least = 0, most = 0;           ///< s, where it is possible,
  double between = 0, and_between = 0;  ///< but not between these: there it is neither root.
  double radii = 0;                     ///< From the ray's origin to the centre.
  bool is_doubtful() const { return is_possible && !is_certain; }
  bool allows(const std::optional<double>& s) const {
    if (!s) return !is_certain;
    return is_possible && least <= *s && *s <= most && !(between < *s && *s < and_between);
  }
};
PossibleHit possible_hit(Arithmetic arithmetic, const scene::Ray& ray, const scene::Sphere& sphere,
                         const scene::Conventions& conventions);

/// Whether a formula may show a sphere along a ray.
struct PossibleSight {
  bool allows = false;       ///< The answer that was shown is possible.
  bool is_doubtful = false;  ///< More than one answer is possible.
  double radii = 0;          ///< The distance, in radii, of the most doubtful sphere.
};
PossibleSight possible_sight(Arithmetic arithmetic, const scene::Ray& ray,
                             std::span<const scene::Sphere> spheres,
                             const scene::Conventions& conventions,
                             const std::optional<std::size_t>& shown);

/// "computed in single precision", or what d^2 loses; `radii` is the distance of a sphere there.
std::string imprecision_sentence(Arithmetic arithmetic, double radii);

/// Roundings are named if they allow every wrong answer, if at least this many answers are wrong
/// besides those about spheres that no answer hits, if at most kMostInDoubt of all answers are in
/// doubt, and at least kFewestWrongInDoubt of those are wrong.
inline constexpr std::uint64_t kFewestWrongByRoundings = 3;
inline constexpr double kMostInDoubt = 0.5;
inline constexpr double kFewestWrongInDoubt = 0.05;

/// Answers, and how the roundings of a formula agree with them.
struct DoubtTally {
  std::uint64_t answers = 0, doubtful = 0, wrong = 0, not_allowed = 0;
  std::uint64_t dropped = 0;  ///< Wrong ones, about spheres that no answer hits.
  double radii = 0;           ///< The least distance of a wrong answer that is allowed; or 0.
  std::uint64_t hits = 0,
                precise = 0;  ///< Right ones, and those with more digits than floats have.

  void add(bool is_wrong, bool is_dropped, bool is_allowed, bool is_doubtful, double its_radii);
  /// Whether there are wrong answers, and the roundings allow all of them.
  bool allows_all() const { return wrong > 0 && not_allowed == 0; }
  /// Whether allows_all(), and the roundings may be named, as above.
  bool tells() const;
};

}  // namespace raycheck::properties
