#include "reference/account/nearby_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/account/internal/choice_forms.h"
#include "reference/account/internal/possible_meeting.h"
#include "reference/account/nearby_valid.h"
#include "reference/internal/classify.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

using Conditions = std::vector<ChoiceCondition>;
using What = ChoiceCondition::What;

/// The largest number of spheres whose inputs may change, and of ways to meet them that are tried.
constexpr std::size_t kMostSpheres = 12;
constexpr int kMostWays = 64;
/// The largest number of parts into which a neighbourhood is divided.
constexpr std::size_t kMostParts = 64;

struct ChoiceQuestion {
  const ExactRay& ray;
  std::span<const scene::Sphere> spheres;
  std::vector<std::size_t> contenders;  ///< The spheres that matter.
  const Neighbourhood& around;
  const FirstMet& claim;
};

/// Whether a claim is right, or else a sphere that makes it wrong; neither if it is undecided.
struct Judgement {
  bool is_right = false;
  std::optional<std::size_t> offender;
};

/// Judges by meet(sphere), which returns an Intersection, and order(sphere, intersection, sphere',
/// intersection'), which returns the sign of s - s'; both return empty if it is unknown. The
/// claimed sphere is judged first.
template <class Meet, class Order>
Judgement judge_by(const ChoiceQuestion& question, Meet meet, Order order) {
  const FirstMet& claim = question.claim;
  const scene::Tangent tangent = question.around.tangent;
  const auto is_unjudged = [&](const Intersection& at) {
    return at.hit_class == HitClass::kTangent && tangent == scene::Tangent::kEither;
  };
  std::optional<Intersection> favourite;
  if (claim.what == FirstMet::What::kSphere) {
    favourite = meet(claim.sphere);
    if (!favourite) return {};
    if (is_unjudged(*favourite) || !counts_as_hit(favourite->hit_class, tangent)) {
      return {false, claim.sphere};
    }
  }
  for (const std::size_t k : question.contenders) {
    if (favourite && k == claim.sphere) continue;
    const std::optional<Intersection> at = meet(k);
    if (!at) return {};
    if (is_unjudged(*at)) return {false, k};
    if (!counts_as_hit(at->hit_class, tangent)) continue;
    if (!favourite) {
      return claim.what == FirstMet::What::kSomething ? Judgement{true, {}} : Judgement{false, k};
    }
    const std::optional<int> sign = order(k, *at, claim.sphere, *favourite);
    if (!sign) return {};
    if (*sign < 0) return {false, k};
  }
  return {claim.what != FirstMet::What::kSomething, {}};
}

Judgement judge(const ChoiceQuestion& question) {
  return judge_by(
      question,
      [&](std::size_t k) {
        return std::optional(question.ray.intersect(question.spheres[k], question.around.root));
      },
      [&](std::size_t k, const Intersection& at, std::size_t other, const Intersection& there) {
        const auto& spheres = question.spheres;
        return std::optional(question.ray.compare(spheres[k], at, spheres[other], there));
      });
}

/// Judges the changed inputs by balls.
Judgement judge_changed(const ChoiceQuestion& question, const InputChange& change) {
  const ExactRay::Source& source = question.ray.source();
  constexpr std::size_t kOfSphere = kSphereInputs;
  const std::size_t of_ray = (source.camera ? kCameraInputs : kGivenInputs) - kOfSphere;
  Judgement result;
  for (int bits = kFirstWitnessBits; bits <= kLastWitnessBits; bits *= 4) {
    const ChangedLift lift(bits, change);
    const auto line = line_of(lift, source);
    const auto pair_of = [&](std::size_t k) {
      const ChangedLift of_sphere(bits, change, of_ray + kOfSphere * k);
      return line_and_sphere(line, lift_sphere(of_sphere, question.spheres[k]));
    };
    const auto meet = [&](std::size_t k) {
      const auto pair = pair_of(k);
      return classify([&](Coefficient coefficient) { return sign_of(coefficient, pair); },
                      question.around.root);
    };
    const auto order = [&](std::size_t k, const Intersection& at, std::size_t other,
                           const Intersection& there) {
      return (scaled_distance(pair_of(k), root_sign(at)) -
              scaled_distance(pair_of(other), root_sign(there)))
          .certain_sign();
    };
    result = judge_by(question, meet, order);
    if (result.is_right || result.offender) break;
  }
  return result;
}

class ChoiceSearch {
 public:
  ChoiceSearch(const ExactRay& ray, std::span<const scene::Sphere> spheres,
               const Neighbourhood& around, const FirstMet& claim)
      : question_{ray, spheres, {}, around, claim} {}

  NearbyAnswer run() {
    Contenders found =
        contenders(question_.ray, question_.spheres, question_.around, question_.claim);
    if (found.is_right) return {*found.is_right ? Nearby::kWitness : Nearby::kRefuted, {}};
    question_.contenders = std::move(found.spheres);
    const Judgement as_it_is = judge(question_);
    if (as_it_is.is_right) return {Nearby::kWitness, {}};
    if (question_.claim.what == FirstMet::What::kSomething) return meet_some();
    if (question_.claim.what == FirstMet::What::kSphere) slots_.push_back(question_.claim.sphere);
    // Adds spheres that make a witness wrong, until there are no more.
    for (std::optional<std::size_t> next = as_it_is.offender; slots_.size() <= kMostSpheres;) {
      if (next && !is_slot(*next)) slots_.push_back(*next);
      if (slots_.empty()) return {};
      offender_.reset();
      NearbyAnswer answer = look_into_slots();
      if (answer.found != Nearby::kUndecided || !offender_) return answer;
      next = offender_;
    }
    return {};
  }

 private:
  NearbyAnswer meet_some() {
    Nearby found = Nearby::kRefuted;
    for (const std::size_t k : question_.contenders) {
      slots_ = {k};
      NearbyAnswer answer = look_into_slots();
      if (answer.found == Nearby::kWitness) return answer;
      if (answer.found == Nearby::kUndecided) found = answer.found;
    }
    return {found, {}};
  }

  NearbyAnswer look_into_slots() {
    std::vector<scene::Sphere> chosen;
    for (const std::size_t k : slots_) chosen.push_back(question_.spheres[k]);
    inputs_.emplace(question_.ray, chosen, question_.around.relative_change);
    const std::size_t n = inputs_->dimension();
    whole_.emplace(*inputs_, Part{std::vector<double>(n), std::vector<double>(n, 1.0)});
    witness_.reset();
    open_.clear();
    is_refuted_ = true;
    ways_ = 0;
    const bool nothing = question_.claim.what == FirstMet::What::kNothing;
    if (nothing) {
      take_next(0, 0, {});
    } else {
      for (const int root : hit_roots()) take(hit(0, root), 1, root, {});
    }
    // If another sphere makes the claim wrong, it is added before the costly search of parts.
    if (offender_ && !open_.empty()) is_refuted_ = false;
    for (const Conditions& all : open_) {
      if (!witness_ && is_refuted_) search_parts(all);
    }
    if (witness_) return {Nearby::kWitness, std::move(*witness_)};
    return {is_refuted_ ? Nearby::kRefuted : Nearby::kUndecided, {}};
  }

  bool is_slot(std::size_t sphere) const {
    return std::find(slots_.begin(), slots_.end(), sphere) != slots_.end();
  }

  std::vector<int> hit_roots() const {
    return question_.around.root == scene::Root::kNearest ? std::vector{-1, 1} : std::vector{-1};
  }

  Conditions hit(std::size_t slot, int root) const {
    if (root > 0) return {{What::kConstant, slot, -1}};
    const bool tangents_count = question_.around.tangent == scene::Tangent::kHit;
    return {{What::kDiscriminant, slot, 1, !tangents_count},
            {What::kConstant, slot},
            {What::kLinear, slot}};
  }

  std::vector<Conditions> misses(std::size_t slot) const {
    const bool tangents_count = question_.around.tangent == scene::Tangent::kMiss;
    const bool is_nearest = question_.around.root == scene::Root::kNearest;
    std::vector<Conditions> result = {
        {{What::kDiscriminant, slot, -1, !tangents_count}},
        {{What::kConstant, slot, 1, is_nearest}, {What::kLinear, slot, -1, true}}};
    if (!is_nearest) result.push_back({{What::kConstant, slot, -1, true}});
    return result;
  }

  /// The ways in which a sphere does not make the claim wrong if the favourite is met at this root.
  std::vector<Conditions> ways_past(std::size_t slot, int favourite_root) const {
    std::vector<Conditions> result = misses(slot);
    if (question_.claim.what != FirstMet::What::kSphere) return result;
    for (const int root : hit_roots()) {
      Conditions after = {{What::kAfter, slot, 1, false, 0, root, favourite_root}};
      for (const ChoiceCondition& condition : hit(slot, root)) after.push_back(condition);
      result.push_back(std::move(after));
    }
    return result;
  }

  void take_next(std::size_t slot, int favourite_root, const Conditions& all) {
    if (slot == slots_.size()) return find_witness(all);
    for (const Conditions& way : ways_past(slot, favourite_root)) {
      take(way, slot + 1, favourite_root, all);
    }
  }

  /// Adds conditions, except those that always hold, and goes on with the next sphere. Ends if a
  /// condition cannot hold.
  void take(const Conditions& more, std::size_t next, int favourite_root, Conditions all) {
    if (witness_) return;
    for (const ChoiceCondition& condition : more) {
      const Variation varied = whole_->of(condition);
      if (is_impossible(varied, condition)) return;
      if (is_certain(varied)) continue;
      all.push_back(condition);
      if (condition.what != What::kAfter || varied.is_finite()) continue;
      // A root that may be double has no derivative; these conditions need none.
      all.back().what = What::kOutside;
      if (is_impossible(whole_->of(all.back()), all.back())) return;
      if (condition.root > 0) continue;
      all.push_back(condition);
      all.back().what = What::kBeforeMiddle;
      if (is_impossible(whole_->of(all.back()), all.back())) return;
    }
    const std::vector<Variation> varied = variations(*whole_, all);
    if (exclude_each_other(varied, best_place(varied, inputs_->dimension()))) return;
    if (++ways_ > kMostWays) {
      is_refuted_ = false;
      return;
    }
    take_next(next, favourite_root, all);
  }

  static bool is_impossible(const Variation& varied, const ChoiceCondition& condition) {
    const auto is_below = [&](const Enclosure& most) {
      const std::optional<int> sign = most.certain_sign();
      return sign && (condition.is_strict ? *sign <= 0 : *sign < 0);
    };
    return is_below(varied.value + varied.most) || (varied.range && is_below(*varied.range));
  }
  static bool is_certain(const Variation& varied) {
    return (varied.value - varied.most).certain_sign() == 1 ||
           (varied.range && varied.range->certain_sign() == 1);
  }

  static std::vector<Variation> variations(const ChoiceForms& forms, const Conditions& all) {
    std::vector<Variation> result;
    for (const ChoiceCondition& condition : all) result.push_back(forms.of(condition));
    return result;
  }

  /// Searches for a witness by linear programs, each about the point that the last one found.
  void find_witness(const Conditions& all) {
    const std::size_t n = inputs_->dimension();
    std::vector<double> t = best_place(variations(*whole_, all), n).t;
    for (int step = 0; step < kPrograms && !is_witness(t); ++step) {
      t = best_place(variations(ChoiceForms(*inputs_, Part{t, {}}), all), n).t;
    }
    if (!witness_) open_.push_back(all);
  }

  /// Searches halves of the neighbourhood, each halved again along the input that matters most.
  /// Needed if the conditions are not linear enough over the whole neighbourhood.
  void search_parts(const Conditions& all) {
    const std::size_t n = inputs_->dimension();
    std::vector<Part> parts = {{std::vector<double>(n), std::vector<double>(n, 1.0)}};
    for (std::size_t next = 0; next < parts.size(); ++next) {
      if (next == kMostParts) {
        is_refuted_ = false;
        return;
      }
      const Part part = parts[next];
      const std::vector<Variation> varied = variations(ChoiceForms(*inputs_, part), all);
      bool is_out = false;
      for (std::size_t i = 0; i < all.size(); ++i) {
        is_out = is_out || is_impossible(varied[i], all[i]);
      }
      if (is_out) continue;
      const LeastOptimum optimum = best_place(varied, n);
      if (exclude_each_other(varied, optimum)) continue;
      std::vector<double> t = optimum.t;
      for (std::size_t k = 0; k < n; ++k) t[k] = part.middle[k] + part.half_width[k] * t[k];
      if (is_witness(t)) return;
      const std::size_t k = most_influential(varied);
      for (const double side : {-0.5, 0.5}) {
        Part half = part;
        half.half_width[k] *= 0.5;
        half.middle[k] += side * part.half_width[k];
        parts.push_back(std::move(half));
      }
    }
  }

  static std::size_t most_influential(const std::vector<Variation>& all) {
    std::vector<double> influence(all.front().reach.size());
    for (const Variation& varied : all) {
      for (std::size_t k = 0; k < influence.size(); ++k) {
        const double share = (abs(varied.reach[k]) / varied.most).upper();
        if (std::isfinite(share)) influence[k] = std::max(influence[k], share);
      }
    }
    return static_cast<std::size_t>(std::max_element(influence.begin(), influence.end()) -
                                    influence.begin());
  }

  bool is_witness(const std::vector<double>& t) {
    InputChange change = change_at(t);
    const Judgement there = judge_changed(question_, change);
    if (there.offender && !is_slot(*there.offender)) offender_ = there.offender;
    if (there.is_right) witness_ = std::move(change);
    return there.is_right;
  }

  InputChange change_at(const std::vector<double>& t) const {
    constexpr std::size_t kOfSphere = kSphereInputs;
    const std::size_t of_ray = inputs_->of_ray();
    InputChange change(of_ray);
    for (std::size_t k = 0; k < t.size(); ++k) {
      const std::size_t beyond = k < of_ray ? 0 : k - of_ray;
      const std::size_t place =
          k < of_ray ? k : of_ray + kOfSphere * slots_[beyond / kOfSphere] + beyond % kOfSphere;
      if (place >= change.size()) change.resize(place + 1);
      change[place] = t[k] * question_.around.relative_change;
    }
    while (!change.empty() && change.back() == 0) change.pop_back();
    return change;
  }

  ChoiceQuestion question_;

  std::vector<std::size_t> slots_;  ///< The spheres whose inputs change, the claimed one first.
  std::optional<ChoiceNumbers> inputs_;
  std::optional<ChoiceForms> whole_;
  std::optional<InputChange> witness_;
  std::optional<std::size_t> offender_;
  std::vector<Conditions> open_;  ///< Ways with neither a witness nor a refutation so far.
  bool is_refuted_ = true;
  int ways_ = 0;
};

/// A separate function, so that the compiler moves no operation to where the caller's rounding mode
/// applies.
[[gnu::noinline]] NearbyAnswer search(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                                      const Neighbourhood& around, const FirstMet& claim) {
  return ChoiceSearch(ray, spheres, around, claim).run();
}

}  // namespace

NearbyAnswer right_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                          const Neighbourhood& around, const FirstMet& claim) {
  for (const scene::Sphere& sphere : spheres) scene::require_valid(sphere);
  if (claim.what == FirstMet::What::kSphere && claim.sphere >= spheres.size()) {
    throw std::invalid_argument("the claimed sphere is not in the scene");
  }
  if (!around.valid.is_usual()) {
    NearbyAnswer found = refuted_nearby(ray, spheres, around, claim);
    if (found.found == Nearby::kRefuted || ends_matter_nearby(ray, spheres, around)) return found;
    Neighbourhood usual = around;
    usual.valid = {};
    return right_nearby(ray, spheres, usual, claim);
  }
  const NearestGuard guard;
  return search(ray, spheres, around, claim);
}

}  // namespace raycheck::reference
