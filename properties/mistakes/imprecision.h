#pragma once

// The different answers that correct formulas may give if roundings decide.

#include <algorithm>
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
/// The arithmetics that are mistakes and show in pictures.
inline constexpr std::array<Arithmetic, 3> kArithmetics = {
    Arithmetic::kDifference, Arithmetic::kSingle, Arithmetic::kSingleDifference};

/// The number of roundings, each by at most u of a term, from the numbers of a scene to d^2: 5 in
/// |T|^2, 15 in v^2 (T, D, their product and the square), and those in r^2 and the differences.
inline constexpr double kRoundings = 24;

/// The answers that a formula may find for a ray and a sphere: a range of s, a miss, or both.
struct PossibleHit {
  bool is_possible = false, is_certain = false;
  double least = 0, most = 0;           ///< The range of s, if a hit is possible,
  double between = 0, and_between = 0;  ///< except between these: there it is neither root.
  double radii = 0;                     ///< From the ray's origin to the centre.
  bool is_doubtful() const { return is_possible && !is_certain; }
  bool allows(const std::optional<double>& s) const {
    if (!s) return !is_certain;
    return is_possible && least <= *s && *s <= most && !(between < *s && *s < and_between);
  }
};
PossibleHit possible_hit(Arithmetic arithmetic, const Ray& ray, const Sphere& sphere,
                         const Conventions& conventions);

/// Whether a formula may show, along a ray, what a picture shows.
struct PossibleSight {
  bool allows = false;       ///< The answer that was shown is possible.
  bool is_doubtful = false;  ///< More than one answer is possible.
  double radii = 0;          ///< The distance, in radii, of the most doubtful sphere.
};
PossibleSight possible_sight(Arithmetic arithmetic, const Ray& ray, std::span<const Sphere> spheres,
                             const Conventions& conventions,
                             const std::optional<std::size_t>& shown);

/// The sentence for a formula, whose d^2 loses all digits at this distance in radii.
std::string imprecision_sentence(Arithmetic arithmetic, double radii);

/// Roundings are named if they allow every wrong answer, if at least kFewestWrongByRoundings
/// answers are wrong (without answers about spheres that no answer hits), if at most the share
/// kMostInDoubt of all answers is in doubt, and if the number of wrong answers is at least
/// kFewestWrongInDoubt times the number of those in doubt.
inline constexpr std::uint64_t kFewestWrongByRoundings = 3;
inline constexpr double kMostInDoubt = 0.5;
inline constexpr double kFewestWrongInDoubt = 0.05;
/// Roundings err to both sides.
inline constexpr std::uint64_t kFewestOnOneSide = 3;

/// Counts of answers, and of how the roundings of a formula agree with them.
struct DoubtTally {
  std::uint64_t answers = 0, doubtful = 0, wrong = 0, not_allowed = 0;
  std::uint64_t dropped = 0;  ///< Wrong answers about spheres that no answer hits.
  double radii = 0;  ///< The least distance of an allowed wrong answer; 0 if there is none.
  std::uint64_t hits = 0,
                precise = 0;  ///< Right ones, and those with more digits than floats have.
  /// Wrong answers as of a larger sphere, and as of a smaller one.
  std::uint64_t outward = 0, inward = 0;

  void add(bool is_wrong, bool is_dropped, bool is_allowed, bool is_doubtful, double its_radii);
  /// Whether all wrong answers are as of a larger sphere, or all as of a smaller one.
  bool is_one_sided() const {
    return outward + inward >= kFewestOnOneSide && std::min(outward, inward) == 0;
  }
  /// Whether no wrong answer contradicts the roundings. tells(): and whether they may be named, as
  /// above.
  bool allows_all() const { return wrong > 0 && not_allowed == 0; }
  /// Whether allows_all(), and the roundings may be named, as above.
  bool tells() const;
};

}  // namespace raycheck::properties
