#include "properties/tally.h"

#include <algorithm>

namespace raycheck::properties {

void Tally::note_worst(double badness, const Place& place, std::optional<double> condition) {
  const bool is_new = badness > worst || (badness == worst && is_earlier(place, worst_place));
  if (is_new) {
    worst = badness;
    worst_place = place;
    worst_condition = condition;
  } else if (condition && badness == worst && !is_earlier(worst_place, place)) {
    worst_condition = std::max(worst_condition.value_or(0), *condition);
  }
}

void Tally::merge(const Tally& other) {
  cases += other.cases;
  right += other.right;
  for (const auto& [kind, number] : other.wrong) wrong[kind] += number;
  for (std::size_t k = 0; k < kStandingCount; ++k) {
    wrong_by_standing[k] += other.wrong_by_standing[k];
  }
  for (std::size_t k = 0; k < kExpectedCount; ++k) {
    answered[k].merge(other.answered[k]);
  }
  errors.merge(other.errors);
  least_bound = std::min(least_bound, other.least_bound);
  greatest_bound = std::max(greatest_bound, other.greatest_bound);
  ill_conditioned += other.ill_conditioned;
  if (other.worst >= 0) note_worst(other.worst, other.worst_place, other.worst_condition);
  conditions.merge(other.conditions);
  worst_ratio = std::max(worst_ratio, other.worst_ratio);
  for (std::size_t k = 0; k < kOutcomeCount; ++k) outcomes[k] += other.outcomes[k];
  max_over_growth = std::max(max_over_growth, other.max_over_growth);
}

std::uint64_t Tally::wrong_answers() const {
  std::uint64_t sum = 0;
  for (const auto& [kind, number] : wrong) sum += number;
  return sum;
}

std::uint64_t Tally::count(Wrong kind) const {
  const auto found = wrong.find(kind);
  return found == wrong.end() ? 0 : found->second;
}

}  // namespace raycheck::properties
