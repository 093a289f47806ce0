#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/decision.h"
#include "properties/discrepancy.h"
#include "properties/excuse.h"
#include "properties/failures.h"
#include "properties/quantity.h"
#include "properties/tally.h"

namespace raycheck::properties {

/// The most discrepancies that a verdict keeps; a bad candidate has one in every pixel.
inline constexpr std::size_t kKeptDiscrepancies = 1000;

/// A law's verdict on a case, or on several cases, merged. Either the case was left out, with a
/// reason; or the verdict has the comparisons and the discrepancies found. The law holds if none of
/// these is a defect.
class Verdict {
 public:
  /// A verdict without a law, into which verdicts of several laws are merged.
  Verdict() = default;
  /// A verdict of the law with this name, which its discrepancies get.
  explicit Verdict(std::string_view law) : law_(law) {}

  /// Records that the case, or a part of it, was left out.
  void leave_out(std::string reason) { left_out_ = std::move(reason); }

  /// Counts a measured error, and the bound with which it is compared.
  void measured(Quantity quantity, const Place& place, double error, double bound);
  /// Counts the stability of the error that was just measured.
  void weighed(Quantity quantity, const Place& place, double error, const Stability& stability);
  /// Counts an error, already measured, that only its condition number allows.
  void count_ill_conditioned(Quantity quantity) {
    ++tallies_[quantity].ill_conditioned;
    ++tallies_[quantity].answers_to(Expected::kValue).right;
  }
  /// Counts answers that are right.
  void judged_right(Quantity quantity, Expected expected, std::uint64_t count);
  /// Counts a question that is not answered right, without adding a discrepancy.
  void not_right(Quantity quantity, Expected expected) {
    ++tallies_[quantity].answers_to(expected).asked;
  }
  /// Counts an answer that is wrong.
  void judged_wrong(const Decision& decision, Standing standing);
  /// Counts an answer about an exact tangent or a hit at s = 0.
  void note(Fact fact, bool is_hit) {
    Answered& answers = facts_[static_cast<std::size_t>(fact)];
    ++answers.asked;
    answers.right += is_hit ? 1 : 0;
  }
  const Answered& fact(Fact fact) const { return facts_[static_cast<std::size_t>(fact)]; }
  /// Adds a discrepancy under this verdict's law.
  void add(Discrepancy discrepancy);
  void merge(const Verdict& other);
  /// Drops the discrepancies, but keeps their counts.
  void drop_discrepancies() { kept_ = {}; }
  /// Drops the discrepancies, the errors and the condition numbers, but keeps their counts.
  void keep_counts();
  /// Adds `first` to every ray index, because this verdict's case was the part of a larger case
  /// that begins at this ray.
  void shift_rays(std::size_t first);
  /// Changes every place, for example from a ray to its pixel.
  void relocate(const std::function<Place(const Place&)>& new_place);

  const std::map<Quantity, Tally>& tallies() const { return tallies_; }
  /// The tally of a quantity; empty if nothing was compared.
  const Tally& tally(Quantity quantity) const;
  /// The worst discrepancies kept, in the order of worst_first().
  std::vector<Discrepancy> worst(std::size_t count) const;
  std::uint64_t discrepancies() const;
  std::uint64_t count(Standing standing) const {
    return by_standing_[static_cast<std::size_t>(standing)];
  }
  std::uint64_t compared() const;
  /// The number of answers that only a declared tolerance excuses.
  std::uint64_t tolerated() const { return tolerated_; }
  /// Whether there is no defect; if `strictly`, no judged answer that differs from the truth.
  bool holds(bool strictly = false) const;
  /// The first kind of question that was asked but answered right, without an excuse, fewer than
  /// `fewest` times: too few for the law to hold. Values of all quantities are one kind.
  /// `wants_hits`: whether hits must be among the hit classes judged, if there are any.
  std::optional<std::pair<Quantity, Expected>> too_few_right(std::uint64_t fewest,
                                                             bool wants_hits = false) const;
  /// The distinct kinds of the kept discrepancies that break the law, in order.
  std::vector<DefectKind> defects(bool strictly = false) const;
  /// The kinds of the kept discrepancies that are undecided.
  std::vector<DefectKind> undecided() const;
  /// The first known line at which the candidate failed, in kept discrepancies that break the law.
  std::optional<CodeLine> failed_at(bool strictly = false) const;
  const std::string& reason_left_out() const { return left_out_; }
  /// Without the law that it belongs to.
  void serialize(auto& archive) {
    archive(left_out_, tallies_, kept_, by_standing_, tolerated_, facts_);
  }

 private:
  void prune();
  std::vector<DefectKind> kinds_of(const std::function<bool(const Discrepancy&)>& is_meant) const;

  std::string_view law_;
  std::string left_out_;
  std::map<Quantity, Tally> tallies_;
  std::vector<Discrepancy> kept_;
  std::array<std::uint64_t, kStandingCount> by_standing_ = {};
  std::uint64_t tolerated_ = 0;
  std::array<Answered, kFactCount> facts_ = {};
};

}  // namespace raycheck::properties
