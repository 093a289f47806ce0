#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "properties/excuse.h"
#include "properties/quantile_sketch.h"
#include "properties/quantity.h"
#include "properties/stability.h"
#include "scene/camera.h"

namespace raycheck::properties {

/// How an answer that is right or wrong was wrong.
enum class Wrong {
  kNot,
  kMissed,
  kFalseHit,
  kWrongSphere,
  kWrongRoot,
  kRefused,
  kAnswered,
  kFailed
};
inline constexpr std::size_t kWrongCount = 8;
inline constexpr std::array<std::string_view, kWrongCount> kWrongNames = {
    "",
    "missed",
    "false hit",
    "wrong sphere",
    "wrong root",
    "refused",
    "answered what is not a problem",
    "failed"};
constexpr std::string_view name(Wrong wrong) {
  return kWrongNames[static_cast<std::size_t>(wrong)];
}

/// The right answer, where the law knows the truth. A law has shown nothing of a kind that was
/// expected and never answered right.
enum class Expected {
  kHit,
  kMiss,
  kSmallerRoot,
  kLargerRoot,
  kNearestOfSeveral,  ///< Of several spheres that a ray meets.
  kOnlySphere,
  kNoSphere,
  kRefusal,
  kValue,  ///< A number or a vector: right is what is within its bound.
};
inline constexpr std::size_t kExpectedCount = 9;
inline constexpr std::array<std::string_view, kExpectedCount> kExpectedNames = {
    "hit",         "miss",      "smaller root", "larger root", "nearest of several",
    "only sphere", "no sphere", "refusal",      "value"};
constexpr std::string_view name(Expected expected) {
  return kExpectedNames[static_cast<std::size_t>(expected)];
}

/// How often something was asked, and how often the answer was right without an excuse.
struct Answered {
  std::uint64_t asked = 0;
  std::uint64_t right = 0;
};

/// Where in a case an answer was asked: a ray (a camera's pixel, or a given ray by its index), and
/// a sphere where the quantity has one.
struct Place {
  std::size_t ray = 0;
  std::optional<scene::Pixel> pixel;
  std::optional<std::size_t> sphere;
};

/// An answer that is right or wrong: what was expected where, and how the answer differs.
struct Decision {
  Quantity quantity;
  Expected expected;
  Place place;
  Wrong wrong;
};

/// The order of places by the ray, then the sphere, then the pixel.
bool is_earlier(const Place& a, const Place& b);

/// What was compared for one quantity. It is the same in whatever order its parts were counted and
/// merged; its memory does not grow with their number (properties/quantile_sketch.h).
struct Tally {
  std::uint64_t cases = 0;  ///< The right ones, the wrong ones and the errors.
  std::uint64_t right = 0;
  std::map<Wrong, std::uint64_t> wrong;
  std::array<std::uint64_t, kStandingCount> wrong_by_standing = {};
  std::array<Answered, kExpectedCount> answered = {};  ///< By what was expected.
  QuantileSketch errors;                               ///< Empty for what is right or wrong.
  /// The least and the greatest bound that an error was held to.
  double least_bound = std::numeric_limits<double>::infinity();
  double greatest_bound = -std::numeric_limits<double>::infinity();
  std::uint64_t ill_conditioned = 0;  ///< Above the flat bound, within its growth: no discrepancy.
  /// The largest error; of what is right or wrong 2 where one is a defect, 1 where all that are
  /// wrong are something else.
  double worst = -1;
  Place worst_place;  ///< The earliest of the worst.
  // Only of trials that ask for the conditioning.
  QuantileSketch conditions;              ///< One for each error.
  std::optional<double> worst_condition;  ///< At worst_place.
  /// The largest stability ratio within the stated domain.
  std::optional<double> worst_ratio;
  std::array<std::uint64_t, kOutcomeCount> outcomes = {};
  /// The largest error over what a documented bound grows by, which is what that bound holds for,
  /// infinite errors aside.
  std::optional<double> max_over_growth;

  void merge(const Tally& other);
  /// Makes an error, or a wrong answer so bad, the worst where it is.
  void note_worst(double badness, const Place& place, std::optional<double> condition = {});

  /// The bound that every error was held to; empty where there is none, or not one alone.
  std::optional<double> bound() const {
    return least_bound == greatest_bound ? std::optional(greatest_bound) : std::nullopt;
  }
  std::uint64_t wrong_answers() const;
  std::uint64_t count(Wrong kind) const;
  std::uint64_t count(Standing standing) const {
    return wrong_by_standing[static_cast<std::size_t>(standing)];
  }
  Answered& answers_to(Expected expected) { return answered[static_cast<std::size_t>(expected)]; }
  std::uint64_t count(Outcome outcome) const { return outcomes[static_cast<std::size_t>(outcome)]; }
  /// Whether every error counted was weighed by its condition number.
  bool is_weighed() const { return errors.count() == conditions.count(); }
  /// All empty when no error was measured. The quantile is the least error that is no smaller than
  /// that share of all, within kSketchResolution; the maximum is exact.
  std::optional<double> quantile(double share) const { return errors.quantile(share); }
  std::optional<double> median() const { return quantile(0.5); }
  std::optional<double> max() const { return errors.max(); }
  /// A quantile of the condition numbers.
  std::optional<double> condition_quantile(double share) const {
    return conditions.quantile(share);
  }
};

}  // namespace raycheck::properties
