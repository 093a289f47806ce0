#pragma once

// The functions of changed inputs that decide whether an answer for a ray and a sphere is right.
// Internal to reference/.

#include <cstddef>
#include <optional>
#include <vector>

#include "reference/account/internal/box_optimum.h"
#include "reference/account/nearby_answer.h"
#include "reference/internal/formulas.h"

namespace raycheck::reference {

/// The first precision of the balls that verify a witness.
inline constexpr int kFirstWitnessBits = 256;
inline constexpr int kLastWitnessBits = 4096;

/// The precision of the balls that enclose how a decider varies over a neighbourhood.
inline constexpr int kVariationBits = 192;

/// Lifts doubles to balls of the changed inputs, in order, starting at `first`. Use a new object
/// for each evaluation. Inputs for which the change has no share are unchanged.
class ChangedLift {
 public:
  using Kernel = EnclosureKernel;

  ChangedLift(int bits, const InputChange& change, std::size_t first = 0)
      : bits_(bits), change_(change), next_(first) {}

  Enclosure operator()(double value) const {
    const Enclosure x(value, bits_);
    const std::size_t k = next_++;
    if (k >= change_.size() || change_[k] == 0) return x;
    return x * (Enclosure(1) + Enclosure(change_[k], bits_));
  }
  Enclosure constant(double value) const { return Enclosure(value, bits_); }

 private:
  int bits_;
  const InputChange& change_;
  mutable std::size_t next_;
};

/// The functions of the inputs that decide whether an answer is right. For a hit at s, mu g is the
/// vector from the origin to the point at s.
enum class Decider {
  kDiscriminant,
  kConstant,
  kLinear,
  kAtAnswer,         ///< |T - mu g|^2 - r^2; 0 if s is a root.
  kBeforeMiddle,     ///< b - a mu; not negative if s is the smaller root.
  kMiddleOffAnswer,  ///< b - a mu, with s exactly as answered.
  kOtherBehind       ///< a mu - 2 b; not negative if the other root, 2 b/a - mu, is not positive.
};
inline constexpr std::size_t kDeciderCount = 7;

/// s in multiples of g.
template <class K>
typename K::FT in_multiples_of_g(const LineAndSphere<K>& pair, const typename K::FT& s) {
  using FT = typename K::FT;
  return pair.line.is_unit ? FT(s / ray_length(pair.line)) : s;
}

/// The vector from the point at s to the centre.
template <class K>
typename K::Vector_3 from_point_at(const LineAndSphere<K>& pair, const typename K::FT& s) {
  return to_centre(pair) - in_multiples_of_g(pair, s) * pair.line.g;
}

template <class K>
typename K::FT value_of(Decider decider, const LineAndSphere<K>& pair, const typename K::FT& s) {
  using FT = typename K::FT;
  const auto mu = [&] { return in_multiples_of_g(pair, s); };
  switch (decider) {
    case Decider::kDiscriminant:
      return discriminant(pair);
    case Decider::kConstant:
      return constant_coefficient(pair);
    case Decider::kLinear:
      return linear_coefficient(pair);
    case Decider::kAtAnswer: {
      const typename K::Vector_3 off = from_point_at(pair, s);
      return FT(off * off) - pair.radius * pair.radius;
    }
    case Decider::kBeforeMiddle:
    case Decider::kMiddleOffAnswer:
      return linear_coefficient(pair) - pair.line.a * mu();
    default: {
      const FT b = linear_coefficient(pair);
      return pair.line.a * mu() - b - b;
    }
  }
}

/// How a decider varies over the neighbourhood, a box. If input k changes by t_k, in [-1, 1], times
/// its range, value + sum_k t_k reach_k encloses the decider's value. If `at` is set, value + sum_k
/// (t_k - at_k) reach_k is its value near the point `at`, to first order only. The last t_k is for
/// the answer's s.
struct Variation {
  Enclosure value;
  std::vector<Enclosure> reach;
  Enclosure most = Enclosure(0);        ///< The sum of |reach|.
  std::vector<double> at = {};          ///< Empty: the middle of the box.
  std::optional<Enclosure> range = {};  ///< Another enclosure of all values.

  bool may_be_positive() const { return (value + most).certain_sign().value_or(1) > 0; }
  bool may_be_at_least_zero() const { return (value + most).certain_sign().value_or(1) >= 0; }
  bool may_be_negative() const { return (value - most).certain_sign().value_or(-1) < 0; }
  bool may_be_at_most_zero() const { return (value - most).certain_sign().value_or(-1) <= 0; }
  bool may_be_zero() const { return may_be_at_least_zero() && may_be_at_most_zero(); }
  bool is_finite() const {
    return arb_is_finite(value.ball()) != 0 && arb_is_finite(most.ball()) != 0;
  }
};

inline Enclosure sum_of_sizes(const std::vector<Enclosure>& terms) {
  Enclosure sum(0);
  for (const Enclosure& term : terms) sum += abs(term);
  return sum;
}

/// shift + sign * variation, for a sign of 1 or -1.
inline Variation shifted(const Variation& variation, int sign, const Enclosure& shift) {
  Variation result = variation;
  if (sign < 0) {
    result.value = -result.value;
    for (Enclosure& reach : result.reach) reach = -reach;
  }
  result.value += shift;
  result.range.reset();
  return result;
}

/// A variation divided by `most`, in doubles, rounded up.
inline LinearForm linear_form(const Variation& variation) {
  const auto share = [&](const Enclosure& part) {
    return variation.most.certain_sign() == 1 ? (part / variation.most).upper() : 0;
  };
  LinearForm form{share(variation.value), {}};
  for (const Enclosure& reach : variation.reach) form.slope.push_back(share(reach));
  for (std::size_t k = 0; k < variation.at.size(); ++k)
    form.value -= form.slope[k] * variation.at[k];
  return form;
}

/// The number of successive linear programs.
inline constexpr int kPrograms = 8;

/// The point of the box at which the least of the variations is largest, to first order. Variations
/// that are not finite do not count.
inline LeastOptimum best_place(const std::vector<Variation>& all, std::size_t dimension) {
  const std::vector<double> flat(dimension);
  if (all.empty()) return {flat, 1, {}};
  std::vector<LinearForm> forms;
  for (const Variation& variation : all) {
    forms.push_back(variation.is_finite() ? linear_form(variation) : LinearForm{1, flat});
  }
  return highest_least(forms);
}

/// Whether the sum of the variations, each times its multiplier, is negative everywhere. Then at
/// every point one of the variations is negative.
inline bool exclude_each_other(const std::vector<Variation>& all,
                               const std::vector<double>& multipliers) {
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

/// Whether the multipliers of the best place show that at every point one variation is negative.
inline bool exclude_each_other(const std::vector<Variation>& all, const LeastOptimum& best) {
  return best.least < 0 && exclude_each_other(all, best.multipliers);
}

}  // namespace raycheck::reference
