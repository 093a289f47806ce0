#include "reference/account/nearby_answer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "reference/account/internal/answer_conditions.h"
#include "reference/account/internal/box_optimum.h"
#include "reference/account/internal/inequalities.h"
#include "reference/account/internal/possible_meeting.h"
#include "reference/account/nearby_valid.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

/// How far inside a condition the discriminant is put when its root must be small, as a share of
/// its reach.
constexpr double kJustInside = 0x1p-44;

/// How many times a point is projected to where conditions hold to first order.
constexpr int kProjections = 32;
/// How far past an inequality's zero a projection goes, times the distance to it.
constexpr double kBeyond = 1 + 0x1p-10;

/// How finely a line through the neighbourhood is searched: steps to each side of its middle, and
/// bisections of a step over which a decider changes sign.
constexpr int kLineSteps = 8;
constexpr int kBisections = 60;

/// The search for inputs near those of a ray and a sphere for which an answer is right.
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
  /// The same by lengths of vectors, where the neighbourhood is so wide that their squares are not
  /// nearly linear. It may find a witness on the way.
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

  /// Where the line just touches the sphere, as close to the answer as possible.
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

  /// The function that is not negative if the answer is near a double root.
  template <class VariationOf>
  std::vector<Variation> near_double_root(const VariationOf& variation_of) {
    const Variation discriminant = variation_of(Decider::kDiscriminant);
    const Variation before = variation_of(Decider::kMiddleOffAnswer);
    const Enclosure most = box_.most_near_double_root();
    return {discriminant, shifted(before, 1, most), shifted(before, -1, most),
            shifted(discriminant, -1, most * most)};
  }

  /// For ill-conditioned inputs, where the deciders are not linear over the neighbourhood: by
  /// successive linear programs, each about the point that the last one found.
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

  /// For neighbourhoods so wide that their ends are far from where answers change: from the middle
  /// to the nearest point where a condition holds to first order, and on from there. Distances
  /// count relative or absolute changes of the inputs.
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
      // Along the gradient, except for inputs already at an end.
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

  /// And if it is far from linear: along lines through the middle, on which all inputs change so
  /// that a decider rises most, or only one does.
  std::optional<InputChange> search_along_lines(const std::vector<Condition>& all) const {
    const Decider decider = all.front().zero.value_or(all.front().what);
    const std::vector<double> rising =
        highest(linear_form(box_.variation_at(decider, box_.middle())));
    if (auto found = search_along(decider, rising)) return found;
    for (std::size_t k = 0; k + 1 < rising.size(); ++k) {
      std::vector<double> alone(rising.size());
      alone[k] = rising[k];
      if (alone[k] == 0) continue;
      if (auto found = search_along(decider, alone)) return found;
    }
    return std::nullopt;
  }

  /// On one line: at every step, and where the decider is 0.
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

/// A separate function, so that no operation moves to where doubles round as the caller set them.
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
    if (found.found == Nearby::kRefuted || ends_matter_nearby(ray, {&sphere, 1}, around)) {
      return found;
    }
    Neighbourhood usual = around;
    usual.valid = {};
    return right_nearby(ray, sphere, usual, answer);
  }
  if (is_far_from_right(ray, sphere, around, answer)) return {Nearby::kRefuted, {}};
  const NearestGuard guard;
  return search(ray, sphere, around, answer);
}

}  // namespace raycheck::reference
