#include "reference/account/nearby_answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "reference/account/internal/answer_box.h"
#include "reference/account/internal/box_optimum.h"
#include "reference/account/internal/possible_meeting.h"
#include "reference/account/nearby_valid.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

/// If the root of the discriminant must be small, the discriminant is set to this share of its
/// reach.
constexpr double kJustInside = 0x1p-44;

/// The number of times that a point is projected to where the conditions hold to first order.
constexpr int kProjections = 32;
/// A projection goes this times as far as to the zero of an inequality.
constexpr double kBeyond = 1 + 0x1p-10;

/// The search along a line: the number of steps to each side of the middle, and of bisections of a
/// step over which a decider changes sign.
constexpr int kLineSteps = 8;
constexpr int kBisections = 60;

/// The condition that `sign` times `what` is not negative; if `sign` is 0, that `what` is as small
/// as near a double root. If `zero` is given, it must be 0, too.
struct Condition {
  std::optional<Decider> zero;
  Decider what;
  int sign = 1;
};

/// Gives the variation of a decider, about a point or over the box.
using VariationOf = std::function<Variation(Decider)>;

/// Witnesses are searched for within these shares of an answer's allowed error. Rounding a witness
/// moves a double root by the square root of the discriminant's change. The first share leaves room
/// for this; the last is nearly all of the allowed error.
constexpr std::array<double, 3> kSharesOfSlack = {1 - 0x1p-3, 1 - 0x1p-8, 1 - 0x1p-30};

/// A condition holds "just inside" if its value is this share of its reach.
constexpr double kInside = 0x1p-20;

/// Whether a condition without `zero` may hold. A line misses if the discriminant is negative, or 0
/// if tangents count as misses. A root at the origin is a hit if the nearest root counts, and a
/// miss if only the smaller root counts and the root at the origin is the larger.
bool may_be(AnswerBox& box, const Variation& f, const Condition& condition) {
  if (condition.sign == 0) {
    Enclosure most = box.most_near_double_root();
    if (condition.what == Decider::kDiscriminant) most *= Enclosure(most);
    return (abs(f.value) - f.most - most).certain_sign().value_or(-1) <= 0;
  }
  const bool tangent_misses = box.around().tangent == scene::Tangent::kMiss;
  const bool zero_counts = condition.what == Decider::kDiscriminant
                               ? tangent_misses == (condition.sign < 0)
                               : condition.what == Decider::kConstant && condition.sign > 0 &&
                                     box.around().root == scene::Root::kSmaller;
  if (zero_counts && f.may_be_zero()) return true;
  return condition.sign > 0 ? f.may_be_positive() : f.may_be_negative();
}

bool is_refuted(AnswerBox& box, const Condition& condition) {
  const Variation& f = box.variation(condition.what);
  if (!condition.zero) return !may_be(box, f, condition);
  const Variation& g = box.variation(*condition.zero);
  if (!g.may_be_zero() || !f.may_be_at_least_zero()) return true;
  const auto optimum = highest_where_zero(linear_form(f), linear_form(g));
  if (!optimum) return false;
  // If g = 0, f is equal to f + multiplier g, which may vary less.
  const Enclosure multiplier = Enclosure(optimum->multiplier, kVariationBits) * f.most / g.most;
  std::vector<Enclosure> reach;
  for (std::size_t k = 0; k < f.reach.size(); ++k) {
    reach.push_back(f.reach[k] + multiplier * g.reach[k]);
  }
  const Variation both{f.value + multiplier * g.value, reach, sum_of_sizes(reach)};
  return !both.may_be_at_least_zero();
}

/// The ways in which an answer may be right, each a list of conditions that must all hold.
std::vector<std::vector<Condition>> alternatives(const AnswerBox& box) {
  const bool only_smaller = box.around().root == scene::Root::kSmaller;
  if (!box.answer()) {
    std::vector<std::vector<Condition>> result = {
        {{{}, Decider::kDiscriminant, -1}},
        {{{}, Decider::kConstant, 1}, {{}, Decider::kLinear, -1}}};
    if (only_smaller) result.push_back({{{}, Decider::kConstant, -1}});
    return result;
  }
  if (!(std::isfinite(*box.answer()) && *box.answer() >= 0)) return {};
  std::vector<std::vector<Condition>> result = {{{Decider::kAtAnswer, Decider::kBeforeMiddle}},
                                                {{{}, Decider::kDiscriminant},
                                                 {{}, Decider::kMiddleOffAnswer, 0},
                                                 {{}, Decider::kDiscriminant, 0}}};
  if (!only_smaller) result.push_back({{Decider::kAtAnswer, Decider::kOtherBehind}});
  return result;
}

/// Whether one of the conditions certainly fails everywhere.
bool are_refuted(AnswerBox& box, const std::vector<Condition>& all) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Condition& condition) { return is_refuted(box, condition); });
}

/// Moves the one coordinate that must move least, so that the decider is 0 up to its last bits.
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

/// Points of the box [-1, 1]^n where the conditions, taken as linear, hold if they can.
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
  // Just inside one condition and as far inside another as possible; for two conditions, or near a
  // double root.
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

/// Searches for inputs near those of a ray and a sphere for which an answer is right.
class AnswerSearch {
 public:
  AnswerSearch(const ExactRay& ray, const scene::Sphere& sphere, const Neighbourhood& around,
               const std::optional<double>& answer)
      : box_(ray, sphere, around, answer) {}

  NearbyAnswer run() {
    bool is_refuted = true;
    for (const std::vector<Condition>& all : alternatives(box_)) {
      if (are_refuted(box_, all)) continue;
      is_refuted = false;
      const auto known = [this](Decider decider) { return box_.variation(decider); };
      for (const std::vector<double>& t : places(box_, all, known)) {
        if (auto witness = box_.change_at(t); box_.is_right(witness)) {
          return {Nearby::kWitness, std::move(witness)};
        }
      }
    }
    if (is_refuted) return {Nearby::kRefuted, {}};
    is_refuted = true;
    for (const std::vector<Condition>& all : alternatives(box_)) {
      std::optional<InputChange> witness;
      if (are_refuted(box_, all) || are_refuted_by_length(all, witness)) continue;
      is_refuted = false;
      if (!witness) witness = search_by_projections(all, box_.middle());
      if (!witness) witness = search_step_by_step(all);
      if (!witness) witness = search_along_lines(all);
      if (witness) return {Nearby::kWitness, std::move(*witness)};
    }
    if (is_refuted) return {Nearby::kRefuted, {}};
    return {};
  }

 private:
  /// Whether lengths of vectors refute the conditions. Needed if the neighbourhood is so wide that
  /// the squares of the lengths are not nearly linear. May also find a witness.
  bool are_refuted_by_length(const std::vector<Condition>& all,
                             std::optional<InputChange>& witness) {
    const Condition& first = all.front();
    if (first.zero == Decider::kAtAnswer) {
      const VectorAndLength off = box_.from_answer();
      const Shortest least = shortest(off);
      const Variation room = less_share_along(off, least.direction);
      if ((room.value + room.most).certain_sign() == -1) return true;
      witness = search_by_projections(all, least.t);
      return false;
    }
    if (first.zero || first.what != Decider::kDiscriminant) return false;
    const VectorAndLength moment = box_.moment();
    if (first.sign > 0) {
      std::vector<Variation> double_root =
          near_double_root([this](Decider decider) { return box_.variation(decider); });
      const Shortest least = shortest(moment);
      double_root.push_back(less_share_along(moment, least.direction));
      const LeastOptimum best = best_place(double_root, box_.middle().size());
      if (exclude_each_other(double_root, best)) return true;
      witness = search_near_double_root(best.t);
      if (!witness) witness = search_near_double_root(least.t);
      return false;
    }
    return is_shorter(moment, box_.direction(), [&](const std::vector<double>& t) {
      if (auto change = box_.change_at(t); box_.is_right(change)) witness = std::move(change);
      return witness.has_value();
    });
  }

  /// Searches where the line just touches the sphere, as close to the answer as possible.
  std::optional<InputChange> search_near_double_root(std::vector<double> t) const {
    for (int step = 0; step < kPrograms; ++step) {
      if (auto change = box_.change_at(t); box_.is_right(change)) return change;
      LinearForm touching = linear_form(box_.variation_at(Decider::kDiscriminant, t));
      touching.value -= kJustInside;
      LinearForm closer = linear_form(box_.variation_at(Decider::kMiddleOffAnswer, t));
      const bool is_before = closer.at(t) > 0;
      closer.value *= is_before ? -1 : 1;
      for (double& slope : closer.slope) slope *= is_before ? -1 : 1;
      const auto optimum = highest_where_zero(closer, touching);
      if (!optimum) break;
      t = optimum->t;
    }
    return std::nullopt;
  }

  /// Variations none of which is negative if the answer is near a double root.
  template <class VariationOf>
  std::vector<Variation> near_double_root(const VariationOf& variation_of) {
    const Variation discriminant = variation_of(Decider::kDiscriminant);
    const Variation before = variation_of(Decider::kMiddleOffAnswer);
    const Enclosure most = box_.most_near_double_root();
    return {discriminant, shifted(before, 1, most), shifted(before, -1, most),
            shifted(discriminant, -1, most * most)};
  }

  /// Searches by successive linear programs, each about the point that the last one found. Needed
  /// for ill-conditioned inputs, for which the deciders are not linear over the neighbourhood.
  std::optional<InputChange> search_step_by_step(const std::vector<Condition>& all) const {
    std::vector<double> t = box_.middle();
    for (int step = 0; step < kPrograms; ++step) {
      const auto here = [&](Decider decider) { return box_.variation_at(decider, t); };
      const std::vector<std::vector<double>> found = places(box_, all, here);
      for (const std::vector<double>& place : found) {
        if (auto change = box_.change_at(place); box_.is_right(change)) return change;
      }
      if (found.empty()) return std::nullopt;
      t = found.front();
    }
    return std::nullopt;
  }

  /// Searches neighbourhoods so wide that their ends are far from where answers change. Goes from
  /// `start` to the nearest point where a condition holds to first order, and on from there.
  /// Distances are measured in relative, then in absolute changes of the inputs.
  std::optional<InputChange> search_by_projections(const std::vector<Condition>& all,
                                                   const std::vector<double>& start) const {
    std::vector<double> sizes = box_.sizes();
    sizes.push_back(0);
    if (auto change = search_by_projections(all, start, sizes)) return change;
    return search_by_projections(all, start, std::vector<double>(sizes.size(), 1));
  }

  std::optional<InputChange> search_by_projections(const std::vector<Condition>& all,
                                                   std::vector<double> t,
                                                   const std::vector<double>& sizes) const {
    const auto project = [&](Decider decider, int sign) {
      const LinearForm f = linear_form(box_.variation_at(decider, t));
      const double value = f.at(t) * (sign == 0 ? 1 : kBeyond);
      if (sign * value > 0) return;
      // Along the gradient, except for inputs that are already at an end.
      std::vector<double> along(t.size());
      double rise = 0;
      for (std::size_t k = 0; k < sizes.size(); ++k) {
        if (sizes[k] == 0) continue;
        const double slope = f.slope[k] / sizes[k];
        if (t[k] == (slope * value > 0 ? -1 : 1)) continue;
        along[k] = slope / sizes[k];
        rise += slope * slope;
      }
      if (rise == 0) return;
      for (std::size_t k = 0; k < t.size(); ++k) {
        t[k] = std::clamp(t[k] - value / rise * along[k], -1.0, 1.0);
      }
    };
    for (int step = 0; step < kProjections; ++step) {
      for (const Condition& condition : all) {
        project(condition.what, condition.sign);
        if (condition.zero) project(*condition.zero, 0);
      }
      std::vector<double> place = t;
      if (const auto& zero = all.front().zero) {
        place = on_zero(box_, *zero, box_.variation_at(*zero, t), std::move(place));
      }
      if (auto change = box_.change_at(place); box_.is_right(change)) return change;
    }
    return std::nullopt;
  }

  /// Searches along lines through the middle, for deciders that are far from linear. On the first
  /// line all inputs change so that the decider rises most; on each other line only one input
  /// changes.
  std::optional<InputChange> search_along_lines(const std::vector<Condition>& all) const {
    const Decider decider = all.front().zero.value_or(all.front().what);
    const std::vector<double> rising =
        highest(linear_form(box_.variation_at(decider, box_.middle())));
    if (auto found = search_along(decider, rising)) return found;
    for (std::size_t k = 0; k + 1 < rising.size(); ++k) {
      std::vector<double> single(rising.size());
      single[k] = rising[k];
      if (single[k] == 0) continue;
      if (auto found = search_along(decider, single)) return found;
    }
    return std::nullopt;
  }

  /// Searches one line: at every step, and where the decider is 0.
  std::optional<InputChange> search_along(Decider decider, const std::vector<double>& line) const {
    const auto at = [&](double share) {
      std::vector<double> t = line;
      for (double& x : t) x *= share;
      return t;
    };
    const auto sign_at = [&](double share) {
      return box_.value_at(decider, at(share)).certain_sign().value_or(0);
    };
    for (int k = -kLineSteps; k <= kLineSteps; ++k) {
      double low = static_cast<double>(k) / kLineSteps;
      double high = std::min(1.0, static_cast<double>(k + 1) / kLineSteps);
      if (auto change = box_.change_at(at(low)); box_.is_right(change)) return change;
      const int sign = sign_at(low);
      if (sign * sign_at(high) >= 0) continue;
      for (int step = 0; step < kBisections; ++step) {
        const double middle = 0.5 * (low + high);
        (sign_at(middle) == sign ? low : high) = middle;
      }
      for (const double share : {low, high}) {
        if (auto change = box_.change_at(at(share)); box_.is_right(change)) return change;
      }
    }
    return std::nullopt;
  }

  AnswerBox box_;
};

/// A separate function, so that the compiler moves no operation to where the caller's rounding mode
/// applies.
[[gnu::noinline]] NearbyAnswer search(const ExactRay& ray, const scene::Sphere& sphere,
                                      const Neighbourhood& around,
                                      const std::optional<double>& answer) {
  return AnswerSearch(ray, sphere, around, answer).run();
}

}  // namespace

NearbyAnswer right_nearby(const ExactRay& ray, const scene::Sphere& sphere,
                          const Neighbourhood& around, const std::optional<double>& answer) {
  scene::require_valid(sphere);
  if (!around.valid.is_usual()) {
    NearbyAnswer found = refuted_nearby(ray, sphere, around, answer);
    Neighbourhood usual = around;
    usual.valid = {};
    const auto reversed = answer ? std::nullopt : reversed_behind(ray, sphere, around);
    if (reversed) return right_nearby(*reversed, sphere, usual, answer);
    if (found.found == Nearby::kRefuted || ends_matter_nearby(ray, {&sphere, 1}, around)) {
      return found;
    }
    return right_nearby(ray, sphere, usual, answer);
  }
  if (is_far_from_right(ray, sphere, around, answer)) return {Nearby::kRefuted, {}};
  const NearestGuard guard;
  return search(ray, sphere, around, answer);
}

}  // namespace raycheck::reference
