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

#include "properties/excuse.h"
#include "properties/failures.h"
#include "properties/quantity.h"
#include "properties/stability.h"
#include "properties/tally.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// What is to blame for an answer that failed.
enum class Blame {
  kNone,      ///< No failure that was searched for.
  kQuestion,  ///< One question, which fails when it is asked alone.
  kAmong,     ///< One of several; not searched for which.
  kTogether,  ///< Several asked at once: asked in parts, they are answered.
  kAnything   ///< It fails whatever it is asked.
};
inline constexpr std::array<std::string_view, 5> kBlameNames = {"none", "question", "among",
                                                                "together", "anything"};
constexpr std::string_view name(Blame blame) {
  return kBlameNames[static_cast<std::size_t>(blame)];
}

/// Where a failure was sought.
struct FailureSite {
  Blame blame = Blame::kNone;
  std::uint64_t count = 0;  ///< How many are to blame, from the discrepancy's place on.
  /// The single question as a scene; empty if there is none, or several.
  std::optional<scene::Scene> scene;
  std::optional<CodeLine> line = {};  ///< In the candidate's source, if known.
};

/// An answer that differs from the truth by more than allowed.
struct Discrepancy {
  std::string_view law;
  Quantity quantity = Quantity::kFrame;
  Place place;
  std::string what;  ///< Which part: "U", "corner (0, 0)", "scaled by 2^40".
  /// The symbol of the numbers got and exact: "s", "Q"; empty if `what` says what they are.
  std::string symbol;
  std::vector<double> got;       ///< Empty: a miss, or no number.
  std::vector<double> exact;     ///< Correctly rounded to `precision`; empty as for got.
  bool got_some_sphere = false;  ///< A picture shows a sphere, but not which.
  double error = 0;              ///< In the quantity's unit; infinite for decisions.
  scene::Precision precision = scene::Precision::kDouble;  ///< The format of that unit.
  Wrong wrong = Wrong::kNot;
  std::optional<double> condition;  ///< The condition number, if asked for.
  Excuse excuse;
  /// The interval that the answered s is judged by, if s lies outside it.
  std::optional<scene::ValidRoots> excluded_by;
  FailureSite failed;  ///< Where it failed.
};

/// Which answers are wrong, and how, wherever they are.
struct DefectKind {
  Quantity quantity = Quantity::kFrame;
  Wrong wrong = Wrong::kNot;  ///< kNot for an error above its bound.
  auto operator<=>(const DefectKind&) const = default;
};

/// Whether a discrepancy breaks a law; if `strictly`, excused and undecided ones do, too.
bool is_held_against(const Discrepancy& discrepancy, bool strictly);

/// The order of reports: by standing, defects first; among those the worst of each quantity first,
/// then the second worst of each, and so on, so that no quantity hides the others. A larger error
/// is worse, then an earlier place, then the law and the part by name.
std::vector<Discrepancy> worst_first(std::vector<Discrepancy> discrepancies);

/// How many discrepancies a verdict keeps; a bad candidate has one in every pixel.
inline constexpr std::size_t kKeptDiscrepancies = 1000;

/// A law's verdict on a case, or on several, merged: left out with a reason, or what was compared
/// and the discrepancies found; it holds when none is a defect.
class Verdict {
 public:
  /// Belongs to no law: others are merged into it.
  Verdict() = default;
  /// Belongs to the law of this name, which its discrepancies then carry.
  explicit Verdict(std::string_view law) : law_(law) {}

  /// Notes that the case, or a part of it, was left out.
  void leave_out(std::string reason) { left_out_ = std::move(reason); }

  /// Counts a measured error, and the bound it is compared with.
  void measured(Quantity quantity, const Place& place, double error, double bound);
  /// Counts the stability of an error just measured.
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
  /// Adds a discrepancy under this verdict's law.
  void add(Discrepancy discrepancy);
  void merge(Verdict other);
  /// Drops the errors, the condition numbers and the discrepancies, but keeps their counts.
  void keep_counts();
  /// Adds to every ray index: this verdict's case was a part of a larger one, starting at that ray.
  void shift_rays(std::size_t first);
  /// Changes every place: from rays to the pixels that they stood for, for example.
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
  /// No defect; if `strictly`, nothing judged differs from the truth.
  bool holds(bool strictly = false) const;
  /// The first quantity and question that was asked, but answered right without an excuse fewer
  /// than `fewest` times: too little for the law to hold. Values are one question, whatever the
  /// quantity. `wants_hits`: if classes were asked for, hits must be among them.
  std::optional<std::pair<Quantity, Expected>> too_few_right(std::uint64_t fewest,
                                                             bool wants_hits = false) const;
  /// The distinct kinds of those kept that break the law, in order.
  std::vector<DefectKind> defects(bool strictly = false) const;
  /// The kinds of those kept that are undecided.
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
