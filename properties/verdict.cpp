#include "properties/verdict.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>

namespace raycheck::properties {
namespace {

std::optional<double> quantile_of(std::vector<double> numbers, double share) {
  if (numbers.empty()) return std::nullopt;
  constexpr double kRounding = 1e-9;  // share * size may be a whole number but for rounding
  const double rank = std::ceil(share * static_cast<double>(numbers.size()) - kRounding);
  const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(std::max(rank - 1, 0.0));
  std::nth_element(numbers.begin(), at, numbers.end());
  return *at;
}

}  // namespace

std::vector<Discrepancy> worst_first(std::vector<Discrepancy> discrepancies) {
  const auto is_excused = [](const Discrepancy& d) { return d.excuse != Excuse::kNone; };
  std::vector<const Discrepancy*> sorted;
  for (const Discrepancy& d : discrepancies) sorted.push_back(&d);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Discrepancy* a, const Discrepancy* b) {
    const auto key = [](const Discrepancy& d) {
      return std::tuple(-d.error, d.place.ray, d.place.sphere.value_or(0));
    };
    return key(*a) < key(*b);
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

std::uint64_t Tally::class_errors() const {
  std::uint64_t sum = 0;
  for (const auto& [kind, count] : wrong) sum += count;
  return sum;
}

std::optional<double> Tally::quantile(double share) const { return quantile_of(errors, share); }

std::optional<double> Tally::condition_quantile(double share) const {
  return quantile_of(conditions, share);
}

std::optional<double> Tally::max() const {
  return errors.empty() ? std::nullopt : std::optional(worst);
}

void Verdict::measured(Quantity quantity, const Place& place, double error) {
  Tally& tally = tallies_[quantity];
  ++tally.cases;
  tally.errors.push_back(error);
  if (error > tally.worst) {
    tally.worst = error;
    tally.worst_place = place;
  }
}

std::optional<double> Tally::max_over_growth() const {
  if (conditions.empty()) return std::nullopt;
  double largest = 0;
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    if (std::isfinite(errors[k])) {
      largest = std::max(largest, errors[k] / bound_growth(conditions[k]));
    }
  }
  return largest;
}

void Verdict::weighed(Quantity quantity, const Stability& stability) {
  Tally& tally = tallies_[quantity];
  tally.conditions.push_back(stability.condition);
  ++tally.outcomes[static_cast<std::size_t>(stability.outcome)];
  if (stability.outcome != Outcome::kOutsideDomain) {
    tally.worst_ratio = std::max(tally.worst_ratio, stability.ratio);
  }
}

void Verdict::judged_right(Quantity quantity, std::uint64_t count) {
  if (count == 0) return;
  Tally& tally = tallies_[quantity];
  tally.cases += count;
  tally.outcomes[static_cast<std::size_t>(Outcome::kExact)] += count;
}

void Verdict::judged(Quantity quantity, const Place& place, Wrong wrong, Excuse excuse) {
  if (wrong == Wrong::kNot) return judged_right(quantity, 1);
  Tally& tally = tallies_[quantity];
  const auto count = [&](Outcome outcome) { ++tally.outcomes[static_cast<std::size_t>(outcome)]; };
  ++tally.cases;
  ++tally.wrong[wrong];
  const bool excused = excuse != Excuse::kNone;
  if (excused) ++tally.wrong_excused;
  count(excuse == Excuse::kOutsideDomain ? Outcome::kOutsideDomain
        : excused                        ? Outcome::kExcusedDecision
                                         : Outcome::kWrongDecision);
  // The first defect, or for want of one the first error.
  const double badness = excused ? 1 : 2;
  if (badness > tally.worst) {
    tally.worst = badness;
    tally.worst_place = place;
  }
}

void Verdict::add(Discrepancy discrepancy) {
  if (!law_.empty()) discrepancy.law = law_;
  ++discrepancies_;
  if (discrepancy.excuse != Excuse::kNone) ++excused_;
  kept_.push_back(std::move(discrepancy));
  if (kept_.size() >= 2 * kKeptDiscrepancies) prune();
}

void Verdict::merge(Verdict other) {
  if (!other.left_out_.empty()) left_out_ = std::move(other.left_out_);
  for (auto& [quantity, tally] : other.tallies_) {
    Tally& mine = tallies_[quantity];
    mine.cases += tally.cases;
    mine.wrong_excused += tally.wrong_excused;
    mine.ill_conditioned += tally.ill_conditioned;
    for (const auto& [kind, count] : tally.wrong) mine.wrong[kind] += count;
    mine.errors.insert(mine.errors.end(), tally.errors.begin(), tally.errors.end());
    mine.conditions.insert(mine.conditions.end(), tally.conditions.begin(), tally.conditions.end());
    mine.worst_ratio = std::max(mine.worst_ratio, tally.worst_ratio);
    for (std::size_t k = 0; k < kOutcomeCount; ++k) mine.outcomes[k] += tally.outcomes[k];
    if (tally.worst > mine.worst) {
      mine.worst = tally.worst;
      mine.worst_place = tally.worst_place;
    }
  }
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
