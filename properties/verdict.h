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
#include "properties/stability.h"
#include "properties/tally.h"

namespace raycheck::properties {

/// The most discrepancies that a verdict keeps; a bad candidate has one in every pixel.
inline constexpr std::size_t kKeptDiscrepancies = 1000;

/// A law's verdict on a case, or on several, merged: left out with a reason, or the comparisons
/// and the discrepancies found; it holds when none is a defect.
class Verdict {
 public:
  /// Without a law: verdicts of several are merged into it.
  Verdict() = default;
  /// Belongs to the law of this name, which its discrepancies then carry.
  explicit Verdict(std::string_view law) : law_(law) {}

  /// Records that the case, or a part of it, was left out.
  void leave_out(std::string reason) { left_out_ = std::move(reason); }

  /// Counts a measured error, and the bound it is compared with.
  void measured(Quantity quantity, const Place& place, double error, double bound);
  /// Counts the stability of an error just measured.
  void weighed(Quantity quantity, const Place& place, double error, const Stability& stability);
  /// Counts an error, already measured, that is allowed only by its condition number.
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
  /// Adds a discrepancy under this verdict's law.
  void add(Discrepancy discrepancy);
  void merge(const Verdict& other);
  /// Drops the discrepancies, and keeps their counts;
  void drop_discrepancies() { kept_ = {}; }
  /// and the errors and the condition numbers, too.
  void keep_counts();
  /// Adds to every ray index: this verdict's case was a part of a larger one, starting at that ray.
  void shift_rays(std::size_t first);
  /// Changes every place: from rays to the pixels that they stood for, for example.
  void relocate(const std::function<Place(const Place&)>& new_place);

  const std::map<Quantity, Tally>& tallies() const { return tallies_; }
  /// The tally of a quantity; empty where nothing was compared.
  const Tally& tally(Quantity quantity) const;
  /// The worst ones kept, in the order of worst_first().
  std::vector<Discrepancy> worst(std::size_t count) const;
  std::uint64_t discrepancies() const;
  std::uint64_t count(Standing standing) const {
    return by_standing_[static_cast<std::size_t>(standing)];
  }
  std::uint64_t compared() const;
  /// Whether there is no defect; if `strictly`, no judged answer that differs from the truth.
  bool holds(bool strictly = false) const;
  /// The first kind of question that was asked, but answered right without an excuse fewer than
  /// `fewest` times: too few for the law to hold. Values of all quantities are one kind.
  /// `wants_hits`: if hit classes were judged, hits must be among them.
  std::optional<std::pair<Quantity, Expected>> too_few_right(std::uint64_t fewest,
                                                             bool wants_hits = false) const;
  /// The distinct kinds of the kept discrepancies that break the law, in order.
  std::vector<DefectKind> defects(bool strictly = false) const;
  /// The kinds of the kept discrepancies that are undecided.
  std::vector<DefectKind> undecided() const;
  /// The first known line at which the candidate failed, of kept discrepancies that break the law.
  std::optional<CodeLine> failed_at(bool strictly = false) const;
  const std::string& reason_left_out() const { return left_out_; }
  /// Without the law that it belongs to.
  void serialize(auto& archive) { archive(left_out_, tallies_, kept_, by_standing_); }

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
