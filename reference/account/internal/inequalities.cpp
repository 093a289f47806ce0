#include "reference/account/internal/inequalities.h"

namespace raycheck::reference {

LeastOptimum best_place(const std::vector<Variation>& all, std::size_t dimension) {
  const std::vector<double> flat(dimension);
  if (all.empty()) return {flat, 1, {}};
  std::vector<LinearForm> forms;
  for (const Variation& variation : all) {
    forms.push_back(variation.is_finite() ? linear_form(variation) : LinearForm{1, flat});
  }
  return highest_least(forms);
}

bool exclude_each_other(const std::vector<Variation>& all, const std::vector<double>& multipliers) {
  Enclosure value(0);
  std::vector<Enclosure> reach(all.front().reach.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (multipliers[i] == 0) continue;
    const Enclosure factor = Enclosure(multipliers[i], kVariationBits) / all[i].most;
    value += factor * all[i].value;
    for (std::size_t k = 0; k < reach.size(); ++k) reach[k] += factor * all[i].reach[k];
  }
  return (value + sum_of_sizes(reach)).certain_sign() == -1;
}

}  // namespace raycheck::reference
