#include "properties/verdict.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace raycheck::properties {

void Verdict::measured(Quantity quantity, const Place& place, double error, double bound) {
  Tally& tally = tallies_[quantity];
  ++tally.cases;
  tally.errors.add(error);
  tally.least_bound = std::min(tally.least_bound, bound);
  tally.greatest_bound = std::max(tally.greatest_bound, bound);
  Answered& values = tally.answers_to(Expected::kValue);
  ++values.asked;
  if (error <= bound) ++values.right;
  tally.note_worst(error, place);
}

const Tally& Verdict::tally(Quantity quantity) const {
  static const Tally nothing;
  const auto found = tallies_.find(quantity);
  return found == tallies_.end() ? nothing : found->second;
}

void Verdict::weighed(Quantity quantity, const Place& place, double error,
                      const Stability& stability) {
  Tally& tally = tallies_[quantity];
  tally.conditions.add(stability.condition);
  tally.note_worst(error, place, stability.condition);
  ++tally.outcomes[static_cast<std::size_t>(stability.outcome)];
  if (stability.outcome != Outcome::kOutsideDomain) {
    tally.worst_ratio = std::max(tally.worst_ratio, std::optional(stability.ratio));
  }
  const double over_growth = std::isfinite(error) ? error / bound_growth(stability.condition) : 0;
  tally.max_over_growth = std::max(tally.max_over_growth.value_or(0), over_growth);
}

void Verdict::judged_right(Quantity quantity, Expected expected, std::uint64_t count) {
  if (count == 0) return;
  Tally& tally = tallies_[quantity];
  Answered& answers = tally.answers_to(expected);
  answers.asked += count;
  answers.right += count;
  tally.cases += count;
  tally.right += count;
  tally.outcomes[static_cast<std::size_t>(Outcome::kExact)] += count;
}

void Verdict::judged_wrong(const Decision& decision, Standing standing) {
  constexpr std::array<Outcome, kStandingCount> kOutcomes = {
      Outcome::kWrongDecision, Outcome::kUndecidedDecision, Outcome::kExcusedDecision,
      Outcome::kOutsideDomain};
  Tally& tally = tallies_[decision.quantity];
  ++tally.cases;
  ++tally.wrong[decision.wrong];
  ++tally.wrong_by_standing[static_cast<std::size_t>(standing)];
  ++tally.outcomes[static_cast<std::size_t>(kOutcomes[static_cast<std::size_t>(standing)])];
  if (standing != Standing::kNotJudged) ++tally.answers_to(decision.expected).asked;
  // The first defect; if there is none, the first error.
  tally.note_worst(standing == Standing::kDefect ? 2 : 1, decision.place);
}

void Verdict::add(Discrepancy discrepancy) {
  if (!law_.empty()) discrepancy.law = law_;
  ++by_standing_[static_cast<std::size_t>(discrepancy.excuse.standing())];
  tolerated_ += discrepancy.excuse.kind == ExcuseKind::kTolerance ? 1 : 0;
  kept_.push_back(std::move(discrepancy));
  if (kept_.size() >= 2 * kKeptDiscrepancies) prune();
}

void Verdict::merge(const Verdict& other) {
  if (&other == this) return merge(Verdict(other));
  if (!other.left_out_.empty()) left_out_ = other.left_out_;
  for (const auto& [quantity, tally] : other.tallies_) tallies_[quantity].merge(tally);
  for (std::size_t k = 0; k < kStandingCount; ++k) by_standing_[k] += other.by_standing_[k];
  tolerated_ += other.tolerated_;
  for (std::size_t k = 0; k < kFactCount; ++k) facts_[k].merge(other.facts_[k]);
  kept_.insert(kept_.end(), other.kept_.begin(), other.kept_.end());
  if (kept_.size() >= 2 * kKeptDiscrepancies) prune();
}

void Verdict::keep_counts() {
  for (auto& [quantity, tally] : tallies_) tally.errors = tally.conditions = {};
  kept_ = {};
}

void Verdict::shift_rays(std::size_t first) {
  relocate([first](Place place) {
    place.ray += first;
    return place;
  });
}

void Verdict::relocate(const std::function<Place(const Place&)>& new_place) {
  for (auto& [quantity, tally] : tallies_) tally.worst_place = new_place(tally.worst_place);
  for (Discrepancy& discrepancy : kept_) discrepancy.place = new_place(discrepancy.place);
}

void Verdict::prune() {
  kept_ = worst_first(std::move(kept_));
  kept_.resize(std::min(kept_.size(), kKeptDiscrepancies));
}

std::vector<Discrepancy> Verdict::worst(std::size_t count) const {
  std::vector<Discrepancy> result = worst_first(kept_);
  result.resize(std::min(result.size(), count));
  return result;
}

std::uint64_t Verdict::discrepancies() const {
  return std::accumulate(by_standing_.begin(), by_standing_.end(), std::uint64_t{0});
}

std::optional<CodeLine> Verdict::failed_at(bool strictly) const {
  for (const Discrepancy& d : kept_) {
    if (d.failed.line && is_held_against(d, strictly)) return d.failed.line;
  }
  return std::nullopt;
}

std::vector<DefectKind> Verdict::defects(bool strictly) const {
  return kinds_of([strictly](const Discrepancy& one) { return is_held_against(one, strictly); });
}

std::vector<DefectKind> Verdict::undecided() const {
  return kinds_of(
      [](const Discrepancy& one) { return one.excuse.standing() == Standing::kUndecided; });
}

std::vector<DefectKind> Verdict::kinds_of(
    const std::function<bool(const Discrepancy&)>& is_meant) const {
  std::set<DefectKind> kinds;
  for (const Discrepancy& one : kept_) {
    if (is_meant(one)) kinds.insert({one.quantity, one.wrong});
  }
  return {kinds.begin(), kinds.end()};
}

bool Verdict::holds(bool strictly) const {
  if (count(Standing::kDefect) > 0) return false;
  return !strictly || discrepancies() == count(Standing::kNotJudged);
}

std::optional<std::pair<Quantity, Expected>> Verdict::too_few_right(std::uint64_t fewest,
                                                                    bool wants_hits) const {
  constexpr auto kOfValues = static_cast<std::size_t>(Expected::kValue);
  std::uint64_t right_values = 0;
  for (const auto& [quantity, tally] : tallies_) right_values += tally.answered[kOfValues].right;
  for (const auto& [quantity, tally] : tallies_) {
    for (std::size_t k = 0; k < kExpectedCount; ++k) {
      const Answered& answers = tally.answered[k];
      const std::uint64_t right = k == kOfValues ? right_values : answers.right;
      const bool is_wanted =
          wants_hits && quantity == Quantity::kClass && static_cast<Expected>(k) == Expected::kHit;
      if ((answers.asked > 0 || is_wanted) && right < fewest) {
        return std::pair(quantity, static_cast<Expected>(k));
      }
    }
  }
  return std::nullopt;
}

std::uint64_t Verdict::compared() const {
  std::uint64_t sum = 0;
  for (const auto& [quantity, tally] : tallies_) sum += tally.cases;
  return sum;
}

}  // namespace raycheck::properties
