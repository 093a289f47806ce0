#include "reference/account/internal/answer_places.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "reference/account/internal/box_optimum.h"

namespace raycheck::reference {
namespace {

/// Shares of an answer's slack in which witnesses are looked for. Rounding a witness moves a double
/// root by the square root of the discriminant's change: the first share leaves room for that, the
/// last is nearly all of the slack.
constexpr std::array<double, 3> kSharesOfSlack = {1 - 0x1p-3, 1 - 0x1p-8, 1 - 0x1p-30};

/// How far "just inside" a condition is, as a share of its reach.
constexpr double kInside = 0x1p-20;

}  // namespace

std::vector<double> on_zero(const AnswerBox& box, Decider decider, const Variation& variation,
                            std::vector<double> t) {
  const std::vector<Enclosure>& reach = variation.reach;
  const Enclosure off = box.value_at(decider, t);
  std::size_t moved = t.size();
  double least = 0;
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    const double step = (off / reach[k]).lower();
    const bool is_possible = std::abs(t[k] - step) <= 1;
    if (is_possible && (moved == t.size() || std::abs(step) < std::abs(least))) {
      moved = k;
      least = step;
    }
  }
  if (moved < t.size()) t[moved] -= least;
  return t;
}

std::vector<std::vector<double>> places(const AnswerBox& box, const std::vector<Condition>& all,
                                        const VariationOf& variation_of) {
  std::vector<std::vector<double>> result;
  const auto slopes = [&](Decider decider, int sign) {
    LinearForm f = linear_form(variation_of(decider));
    f.value *= sign;
    for (double& slope : f.slope) slope *= sign;
    return f;
  };
  for (const Condition& condition : all) {
    const LinearForm f = slopes(condition.what, condition.sign);
    if (!condition.zero) {
      if (condition.sign == 0) continue;
      result.push_back(highest(f));
      result.emplace_back(f.slope.size(), 0.0);
      continue;
    }
    for (const double share : kSharesOfSlack) {
      LinearForm g = slopes(*condition.zero, 1);
      g.slope.back() *= share;
      if (auto optimum = highest_where_zero(f, g)) {
        optimum->t.back() *= share;
        result.push_back(
            on_zero(box, *condition.zero, variation_of(*condition.zero), std::move(optimum->t)));
      }
    }
  }
  // Just inside one condition, as far inside another as possible: for two, or near a double root.
  const auto just_inside = [&](LinearForm first, const LinearForm& second) {
    first.value -= kInside;
    if (auto optimum = highest_where_zero(second, first)) result.push_back(std::move(optimum->t));
  };
  if (all.size() >= 2) {
    const LinearForm first = slopes(all[0].what, all[0].sign);
    for (const int sign : {1, -1}) {
      if (all[1].sign != -sign) just_inside(first, slopes(all[1].what, sign));
    }
  }
  return result;
}

}  // namespace raycheck::reference
