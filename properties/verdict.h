#ifndef RAYCHECK_PROPERTIES_VERDICT_H_
#define RAYCHECK_PROPERTIES_VERDICT_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
inline constexpr std::array<std::string_view, 8> kWrongNames = {"",
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

/// Why a discrepancy is not held against the method.
enum class Excuse { kNone, kSmallChangeFlips, kIllConditioned, kOutsideDomain };
inline constexpr std::array<std::string_view, 4> kExcuseNames = {
    "", "a change of the inputs by 16 u may flip it", "ill-conditioned",
    "outside the method's stated domain"};
constexpr std::string_view name(Excuse excuse) {
  return kExcuseNames[static_cast<std::size_t>(excuse)];
}

/// Where in a case an answer was asked: a ray (a camera's pixel, or a given ray by its index), and
/// a sphere where the quantity has one.
struct Place {
  std::size_t ray = 0;
  std::optional<scene::Pixel> pixel;
  std::optional<std::size_t> sphere;
};

/// One answer that differs from the truth by more than it may.
struct Discrepancy {
  std::string_view law;
  Quantity quantity = Quantity::kFrame;
  Place place;
  std::string what;           ///< Which part: "U", "corner (0, 0)", "scaled by 2^40".
  std::vector<double> got;    ///< Empty: a miss, or no number.
  std::vector<double> exact;  ///< Correctly rounded; empty as for got.
  double error = 0;           ///< In the quantity's unit; infinite where right or wrong.
  Wrong wrong = Wrong::kNot;
  std::optional<double> condition;  ///< The condition number, where it was asked for.
  Excuse excuse = Excuse::kNone;
};

/// The order of reports: without an excuse first; among those the worst of each quantity first,
/// then the second worst of each, and so on, so that no quantity hides the others. Worse is the
/// larger error, then the earlier place.
std::vector<Discrepancy> worst_first(std::vector<Discrepancy> discrepancies);

/// What was compared for one quantity.
struct Tally {
  std::uint64_t cases = 0;
  std::map<Wrong, std::uint64_t> wrong;
  std::uint64_t wrong_excused = 0;    ///< Of those, how many have an excuse.
  std::vector<double> errors;         ///< Empty for what is right or wrong.
  std::uint64_t ill_conditioned = 0;  ///< Above the flat bound, within its growth: no discrepancy.
  double worst = -1;
  Place worst_place;
  // Only of trials that ask for the conditioning.
  std::vector<double> conditions;  ///< One for each error.
  double worst_ratio = -1;         ///< The largest stability ratio within the stated domain.
  std::array<std::uint64_t, kOutcomeCount> outcomes = {};

  std::uint64_t class_errors() const;
  std::uint64_t count(Outcome outcome) const { return outcomes[static_cast<std::size_t>(outcome)]; }
  /// All empty when no error was measured. The quantile is the least error that is no
  /// smaller than that share of all.
  std::optional<double> quantile(double share) const;
  std::optional<double> median() const { return quantile(0.5); }
  std::optional<double> max() const;
  /// The largest error over what a documented bound grows by, which is what that bound holds for,
  /// infinite errors aside; empty unless errors were weighed.
  std::optional<double> max_over_growth() const;
  /// A quantile of the condition numbers.
  std::optional<double> condition_quantile(double share) const;
};

/// How many discrepancies a verdict keeps; a bad candidate has one in every pixel.
inline constexpr std::size_t kKeptDiscrepancies = 1000;

/// The answer of a law on a case, or of several merged: left out with a reason, or what was
/// compared and the discrepancies found; it holds when there are none without an excuse.
class Verdict {
 public:
  /// Speaks for no law: others are merged into it.
  Verdict() = default;
  /// Speaks for the law of that name, which its discrepancies then bear.
  explicit Verdict(std::string_view law) : law_(law) {}

  /// Notes that the case, or a part of it, was left out.
  void leave_out(std::string reason) { left_out_ = std::move(reason); }

  /// Counts a measured error.
  void measured(Quantity quantity, const Place& place, double error);
  /// Counts what the error just measured is worth.
  void weighed(Quantity quantity, const Stability& stability);
  /// Counts an error, measured before, that only its condition number allows.
  void count_ill_conditioned(Quantity quantity) { ++tallies_[quantity].ill_conditioned; }
  /// Counts answers that are right.
  void judged_right(Quantity quantity, std::uint64_t count);
  /// Counts an answer that is right or wrong.
  void judged(Quantity quantity, const Place& place, Wrong wrong, Excuse excuse);
  /// Adds a discrepancy with the law that this verdict speaks for.
  void add(Discrepancy discrepancy);
  void merge(Verdict other);
  /// Adds to every ray index: this verdict's case was a part, from that ray on, of a larger one.
  void shift_rays(std::size_t first);

  const std::map<Quantity, Tally>& tallies() const { return tallies_; }
  /// The worst ones kept, in the order of worst_first().
  std::vector<Discrepancy> worst(std::size_t count) const;
  std::uint64_t discrepancies() const { return discrepancies_; }
  std::uint64_t excused() const { return excused_; }
  std::uint64_t compared() const;
  bool holds() const { return discrepancies_ == excused_; }
  const std::string& reason_left_out() const { return left_out_; }

 private:
  void prune();

  std::string_view law_;
  std::string left_out_;
  std::map<Quantity, Tally> tallies_;
  std::vector<Discrepancy> kept_;
  std::uint64_t discrepancies_ = 0;
  std::uint64_t excused_ = 0;
};

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_VERDICT_H_
