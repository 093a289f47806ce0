#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/code_line.h"
#include "properties/excuse.h"
#include "properties/quantity.h"
#include "properties/stability.h"
#include "properties/tally.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// What is to blame for an answer that failed.
enum class Blame {
  kNone,      ///< None that was sought.
  kQuestion,  ///< One question, which fails when it is asked alone.
  kAmong,     ///< One of several, which was not sought.
  kTogether,  ///< Several asked at once: in parts they are answered.
  kAnything   ///< It would have failed whatever was asked.
};
inline constexpr std::array<std::string_view, 5> kBlameNames = {"none", "question", "among",
                                                                "together", "anything"};
constexpr std::string_view name(Blame blame) {
  return kBlameNames[static_cast<std::size_t>(blame)];
}

/// Where a failure was sought.
struct FailureSite {
  Blame blame = Blame::kNone;
  std::uint64_t count = 0;  ///< Of the questions to blame, from the discrepancy's place on.
  /// The one question as a scene; empty where there is none, or several.
  std::optional<scene::Scene> scene;
  std::optional<CodeLine> line = {};  ///< Of the candidate's source, where that is known.
};

/// One answer that differs from the truth by more than it may.
struct Discrepancy {
  std::string_view law;
  Quantity quantity = Quantity::kFrame;
  Place place;
  std::string what;  ///< Which part: "U", "corner (0, 0)", "scaled by 2^40".
  /// Of the numbers got and exact: "s", "Q"; empty where `what` says what they are.
  std::string symbol;
  std::vector<double> got;       ///< Empty: a miss, or no number.
  std::vector<double> exact;     ///< Correctly rounded to `precision`; empty as for got.
  bool got_some_sphere = false;  ///< A picture shows a sphere, but not which.
  double error = 0;              ///< In the quantity's unit; infinite where right or wrong.
  scene::Precision precision = scene::Precision::kDouble;  ///< What that unit is of.
  Wrong wrong = Wrong::kNot;
  std::optional<double> condition;  ///< The condition number, where it was asked for.
  Excuse excuse;
  /// The interval, where the answered s lies outside of that which it is judged by.
  std::optional<scene::ValidRoots> excluded_by;
  FailureSite failed;  ///< Where it failed.
};

/// Which answers are wrong, and how, wherever they are.
struct DefectKind {
  Quantity quantity = Quantity::kFrame;
  Wrong wrong = Wrong::kNot;  ///< kNot of an error above its bound.
  auto operator<=>(const DefectKind&) const = default;
};

/// Whether a discrepancy breaks a law; `strictly`, what is excused or undecided does, too.
bool is_held_against(const Discrepancy& discrepancy, bool strictly);

/// The order of reports: by standing, defects first; among those the worst of each quantity first,
/// then the second worst of each, and so on, so that no quantity hides the others. Worse is the
/// larger error, then the earlier place, then the law and the part by name.
std::vector<Discrepancy> worst_first(std::vector<Discrepancy> discrepancies);

/// How many discrepancies a verdict keeps; a bad candidate has one in every pixel.
inline constexpr std::size_t kKeptDiscrepancies = 1000;

/// The answer of a law on a case, or of several merged: left out with a reason, or what was
/// compared and the discrepancies found; it holds when none is a defect.
class Verdict {
 public:
  /// Speaks for no law: others are merged into it.
  Verdict() = default;
  /// Speaks for the law of that name, which its discrepancies then bear.
  explicit Verdict(std::string_view law) : law_(law) {}

  /// Notes that the case, or a part of it, was left out.
  void leave_out(std::string reason) { left_out_ = std::move(reason); }

  /// Counts a measured error, and what it is held to.
  void measured(Quantity quantity, const Place& place, double error, double bound);
  /// Counts what an error just measured is worth.
  void weighed(Quantity quantity, const Place& place, double error, const Stability& stability);
  /// Counts an error, measured before, that only its condition number allows.
  void count_ill_conditioned(Quantity quantity) {
    ++tallies_[quantity].ill_conditioned;
    ++tallies_[quantity].answers_to(Expected::kValue).right;
  }
  /// Counts answers that are right.
  void judged_right(Quantity quantity, Expected expected, std::uint64_t count);
  /// Counts something expected to which an answer is not right, though it breaks nothing here.
  void not_right(Quantity quantity, Expected expected) {
    ++tallies_[quantity].answers_to(expected).asked;
  }
  /// Counts an answer that is wrong.
  void judged_wrong(const Decision& decision, Standing standing);
  /// Adds a discrepancy with the law that this verdict speaks for.
  void add(Discrepancy discrepancy);
  void merge(Verdict other);
  /// Forgets the errors, the condition numbers and the discrepancies, and keeps their counts.
  void keep_counts();
  /// Adds to every ray index: this verdict's case was a part, from that ray on, of a larger one.
  void shift_rays(std::size_t first);
  /// Puts everything elsewhere: this verdict's rays stood for pixels, say.
  void relocate(const std::function<Place(const Place&)>& new_place);

  const std::map<Quantity, Tally>& tallies() const { return tallies_; }
  /// That of one quantity; an empty one where nothing was compared.
  const Tally& tally(Quantity quantity) const;
  /// The worst ones kept, in the order of worst_first().
  std::vector<Discrepancy> worst(std::size_t count) const;
  std::uint64_t discrepancies() const;
  std::uint64_t count(Standing standing) const {
    return by_standing_[static_cast<std::size_t>(standing)];
  }
  std::uint64_t compared() const;
  /// No defect; `strictly`, nothing that was judged differs from the truth.
  bool holds(bool strictly = false) const;
  /// The first quantity and question that was asked, but answered rightly, without an excuse, fewer
  /// than so many times: of that a law has shown too little to hold. Values are one question,
  /// whatever the quantity.
  /// `wants_hits`: where classes were asked, hits must have been among them.
  std::optional<std::pair<Quantity, Expected>> too_few_right(std::uint64_t fewest,
                                                             bool wants_hits = false) const;
  /// The kinds of those kept that break the law, each once, in order.
  std::vector<DefectKind> defects(bool strictly = false) const;
  /// The kinds of those kept that are left undecided.
  std::vector<DefectKind> undecided() const;
  /// Of those kept that break the law, the first known line at which the candidate failed.
  std::optional<CodeLine> failed_at(bool strictly = false) const;
  const std::string& reason_left_out() const { return left_out_; }

 private:
  void prune();
  std::vector<DefectKind> kinds_of(const std::function<bool(const Discrepancy&)>& is_meant) const;

  std::string_view law_;
  std::string left_out_;
  std::map<Quantity, Tally> tallies_;
  std::vector<Discrepancy> kept_;
  std::array<std::uint64_t, kStandingCount> by_standing_ = {};
};

}  // namespace raycheck::properties
