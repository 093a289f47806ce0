#include "reference/account/internal/choice_judgement.h"

#include "reference/account/internal/answer_decider.h"
#include "reference/account/internal/condition_impl.h"
#include "reference/internal/classify.h"

namespace raycheck::reference {
namespace {

/// Judges by meet(sphere), an Intersection, and order(sphere, its own, sphere', its own), the sign
/// of s - s'; both empty if unknown. The claimed sphere is judged first.
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

}  // namespace

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

}  // namespace raycheck::reference
