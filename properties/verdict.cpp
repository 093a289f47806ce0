#include "properties/verdict.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>

namespace raycheck::properties {

std::vector<Discrepancy> worst_first(std::vector<Discrepancy> discrepancies) {
  const auto is_excused = [](const Discrepancy& d) { return static_cast<bool>(d.excuse); };
  std::vector<const Discrepancy*> sorted;
  for (const Discrepancy& d : discrepancies) sorted.push_back(&d);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Discrepancy* a, const Discrepancy* b) {
    if (a->error != b->error) return a->error > b->error;
    if (is_earlier(a->place, b->place)) return true;
    if (is_earlier(b->place, a->place)) return false;
    return std::tie(a->law, a->what) < std::tie(b->law, b->what);
  });
  // (excused, rank within its quantity, quantity) of each.
  using Key = std::tuple<bool, std::size_t, Quantity>;
  std::map<std::pair<bool, Quantity>, std::size_t> ranks;
  std::vector<std::pair<Key, const Discrepancy*>> keyed;
  for (const Discrepancy* d : sorted) {
    const std::size_t rank = ranks[{is_excused(*d), d->quantity}]++;
    keyed.emplace_back(Key(is_excused(*d), rank, d->quantity), d);
  }
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Discrepancy> result;
  for (const auto& [key, d] : keyed) result.push_back(*d);
  return result;
}

void Verdict::measured(Quantity quantity, const Place& place, double error, double bound) {
  Tally& tally = tallies_[quantity];
  ++tally.cases;
  tally.errors.add(error);
  tally.least_bound = std::min(tally.least_bound, bound);
  tally.greatest_bound = std::max(tally.greatest_bound, bound);
  tally.note_worst(error, place);
}

void Verdict::weighed(Quantity quantity, const Place& place, double error,
                      const Stability& stability) {
  Tally& tally = tallies_[quantity];
  tally.conditions.add(stability.condition);
  tally.note_worst(error, place, stability.condition);
  ++tally.outcomes[static_cast<std::size_t>(stability.outcome)];
  if (stability.outcome != Outcome::kOutsideDomain) {
    tally.worst_ratio = std::max(tally.worst_ratio, stability.ratio);
  }
  const double over_growth = std::isfinite(error) ? error / bound_growth(stability.condition) : 0;
  tally.max_over_growth = std::max(tally.max_over_growth.value_or(0), over_growth);
}

void Verdict::judged_right(Quantity quantity, std::uint64_t count) {
  if (count == 0) return;
  Tally& tally = tallies_[quantity];
  tally.cases += count;
  tally.right += count;
  tally.outcomes[static_cast<std::size_t>(Outcome::kExact)] += count;
}

void Verdict::judged(Quantity quantity, const Place& place, Wrong wrong, Excuse excuse) {
  if (wrong == Wrong::kNot) return judged_right(quantity, 1);
  Tally& tally = tallies_[quantity];
  const auto count = [&](Outcome outcome) { ++tally.outcomes[static_cast<std::size_t>(outcome)]; };
  ++tally.cases;
  ++tally.wrong[wrong];
  if (excuse) ++tally.wrong_excused;
  count(excuse.kind == ExcuseKind::kOutsideDomain ? Outcome::kOutsideDomain
        : excuse                                  ? Outcome::kExcusedDecision
                                                  : Outcome::kWrongDecision);
  // The first defect, or for want of one the first error.
  tally.note_worst(excuse ? 1 : 2, place);
}

void Verdict::add(Discrepancy discrepancy) {
  if (!law_.empty()) discrepancy.law = law_;
  ++discrepancies_;
  if (discrepancy.excuse) ++excused_;
  kept_.push_back(std::move(discrepancy));
  if (kept_.size() >= 2 * kKeptDiscrepancies) prune();
}

void Verdict::merge(Verdict other) {
  if (!other.left_out_.empty()) left_out_ = std::move(other.left_out_);
  for (const auto& [quantity, tally] : other.tallies_) tallies_[quantity].merge(tally);
  discrepancies_ += other.discrepancies_;
  excused_ += other.excused_;
  std::move(other.kept_.begin(), other.kept_.end(), std::back_inserter(kept_));
  if (kept_.size() >= 2 * kKeptDiscrepancies) prune();
}

void Verdict::shift_rays(std::size_t first) {
  for (auto& [quantity, tally] : tallies_) tally.worst_place.ray += first;
  for (Discrepancy& discrepancy : kept_) discrepancy.place.ray += first;
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

std::uint64_t Verdict::compared() const {
  std::uint64_t sum = 0;
  for (const auto& [quantity, tally] : tallies_) sum += tally.cases;
  return sum;
}

}  // namespace raycheck::properties
