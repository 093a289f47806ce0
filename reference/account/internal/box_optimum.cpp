#include "reference/account/internal/box_optimum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace raycheck::reference {

double LinearForm::at(const std::vector<double>& t) const {
  double sum = value;
  for (std::size_t k = 0; k < slope.size(); ++k) sum += slope[k] * t[k];
  return sum;
}

std::vector<double> highest(const LinearForm& f) {
  std::vector<double> t;
  for (const double slope : f.slope) t.push_back(slope > 0 ? 1 : slope < 0 ? -1 : 0);
  return t;
}

/// At the optimum every t_k is at an end, by the sign of f + multiplier g, except for one that g =
/// 0 sets: as the multiplier rises from minus infinity, they switch ends one by one, and g rises
/// from its minimum.
std::optional<BoxOptimum> highest_where_zero(const LinearForm& f, const LinearForm& g) {
  BoxOptimum result{highest(f), 0};
  std::vector<std::pair<double, std::size_t>> turns;
  double value = g.value;
  for (std::size_t k = 0; k < g.slope.size(); ++k) {
    if (g.slope[k] == 0) continue;
    turns.emplace_back(-f.slope[k] / g.slope[k], k);
    result.t[k] = g.slope[k] > 0 ? -1 : 1;
    value -= std::abs(g.slope[k]);
  }
  if (value > 0) return std::nullopt;
  std::sort(turns.begin(), turns.end());
  for (const auto& [multiplier, k] : turns) {
    const double size = std::abs(g.slope[k]);
    if (value + 2 * size >= 0) {
      result.t[k] -= result.t[k] * std::min(-value / size, 2.0);
      result.multiplier = multiplier;
      return result;
    }
    result.t[k] = -result.t[k];
    value += 2 * size;
  }
  return std::nullopt;
}

}  // namespace raycheck::reference
