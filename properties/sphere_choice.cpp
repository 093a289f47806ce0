#include "properties/sphere_choice.h"

#include <algorithm>

#include "reference/ray_error.h"
#include "reference/visibility/visibility.h"

namespace raycheck::properties {
namespace {

/// What a choice claims about the first hit of its ray.
reference::FirstMet claim_of(Index got) {
  using reference::FirstMet;
  return {!got                 ? FirstMet::What::kNothing
          : got == kSomeSphere ? FirstMet::What::kSomething
                               : FirstMet::What::kSphere,
          got.value_or(0)};
}

/// A declared tolerance that allows a choice, or 0: it is within one, or it is first among the
/// spheres that are not.
double tolerance_of_choice(Trial& trial, std::size_t ray, Index got) {
  if (trial.candidate().tolerances == contract::Tolerances{}) return 0;
  const ExactRay& exact = trial.exact_ray(ray);
  const auto& spheres = trial.scene().spheres;
  double size = 0;
  std::optional<NearestSphere> first;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (const double one = trial.tolerance(exact, spheres[k]); one > 0) {
      size = one;
      if (got == k) return size;
      continue;
    }
    const Intersection at = exact.intersect(spheres[k], trial.conventions());
    if (counts_as_hit(at.hit_class, trial.conventions().tangent)) {
      exact.keep_nearest(spheres, k, at, first);
    }
  }
  return is_right({ray, got, first}) ? size : 0;
}

/// Whether the ray starts inside a sphere, where its hit is not a root that counts.
bool starts_inside_some(Trial& trial, std::size_t ray) {
  return trial.candidate().interface.from_inside != contract::FromInside::kRoot &&
         std::ranges::any_of(trial.scene().spheres, [&](const Sphere& sphere) {
           return starts_inside(trial.exact_ray(ray), sphere);
         });
}

Standing standing_of(Trial& trial, std::size_t ray, Index got) {
  const auto& spheres = trial.scene().spheres;
  const Conventions& conventions = trial.conventions();
  const bool may_be_unjudged =
      std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
        return is_unjudged(trial.exact_ray(ray).intersect(sphere, conventions),
                           conventions.tangent);
      });
  if (!trial.inside_domain() || may_be_unjudged || starts_inside_some(trial, ray)) {
    return Standing::kNotJudged;
  }
  return excuse(trial, ray, got, trial.excused_change()).standing();
}

}  // namespace

bool is_right(const Choice& choice) {
  const auto& [ray, got, exact, what, is_first_of_ties] = choice;
  if (!exact || !got) return !exact && !got;
  if (got == kSomeSphere || *got == exact->index) return true;
  return !is_first_of_ties &&
         std::find(exact->ties.begin(), exact->ties.end(), *got) != exact->ties.end();
}

Wrong wrong_of(const Choice& choice) {
  return is_right(choice) ? Wrong::kNot
         : !choice.exact  ? Wrong::kFalseHit
         : !choice.got    ? Wrong::kMissed
                          : Wrong::kWrongSphere;
}

bool may_be_elsewhere_in_pixel(const ExactRay& ray, std::span<const Sphere> spheres,
                               const Conventions& conventions, Index got, double change) {
  return reference::may_be_right_in_pixel(
      ray, spheres, {conventions.root, conventions.tangent, change, conventions.valid},
      claim_of(got));
}

Excuse excuse(Trial& trial, std::size_t ray, Index got, double change) {
  Excuse found = excuse_of(right_nearby(trial.exact_ray(ray), trial.scene().spheres,
                                        trial.neighbourhood(change), claim_of(got)),
                           change);
  if (found.standing() == Standing::kExcused) return found;
  const double size = tolerance_of_choice(trial, ray, got);
  return size > 0 ? Excuse{ExcuseKind::kTolerance, size} : found;
}

void judge_choice(Trial& trial, Verdict& verdict, const Choice& choice, Expected expected,
                  const std::function<Excuse()>& excuse) {
  const bool got_some = choice.got == kSomeSphere;
  if (choice.got && !got_some) require_sphere(*choice.got, trial.scene().spheres.size());
  const Index sphere = choice.exact ? Index(choice.exact->index) : got_some ? Index() : choice.got;
  trial.judge(
      verdict,
      {Quantity::kNearestSphere, expected, trial.place(choice.ray, sphere), wrong_of(choice)},
      excuse, [&](Discrepancy& d) {
        d.what = choice.what;
        d.got_some_sphere = got_some;
        if (choice.got && !got_some) d.got = {static_cast<double>(*choice.got)};
        if (choice.exact) d.exact = {static_cast<double>(choice.exact->index)};
      });
}

SpheresMet spheres_met(Trial& trial) {
  SpheresMet met{std::vector<std::uint32_t>(trial.ray_count()),
                 std::vector<bool>(trial.ray_count())};
  const scene::Tangent tangent = trial.conventions().tangent;
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    for (const Meeting& meeting : trial.exact_meetings(sphere)) {
      const Intersection& at = meeting.intersection;
      if (is_unjudged(at, tangent)) met.is_unjudged[meeting.ray] = true;
      if (counts_as_hit(at.hit_class, tangent)) ++met.count[meeting.ray];
    }
  }
  for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
    if (!starts_inside_some(trial, ray)) continue;
    met.is_unjudged[ray] = met.some_start_inside = true;
  }
  return met;
}

std::vector<NearestHitError> nearest_hit_errors(Trial& trial, std::span<const std::int32_t> seen) {
  const auto& spheres = trial.scene().spheres;
  std::vector<NearestHitError> errors(seen.size());
  for (std::size_t ray = 0; ray < errors.size(); ++ray) {
    const Index got = trial.nearest().at(ray);
    const Index shown =
        seen[ray] == reference::kNoSphere ? Index() : Index(static_cast<std::size_t>(seen[ray]));
    if (got != shown) {
      const auto nearest = trial.exact_ray(ray).nearest(spheres, trial.conventions());
      errors[ray].wrong = wrong_of({ray, got, nearest});
    }
    if (errors[ray].wrong != Wrong::kNot) {
      errors[ray].standing = standing_of(trial, ray, got);
    } else if (got && !starts_inside_some(trial, ray)) {
      const HitAnswer* const hit = find_hit(trial.hits(*got), ray);
      if (hit == nullptr)
        throw CandidateFailed("the candidate misses the sphere that it names as nearest");
      const ExactRay& exact = trial.exact_ray(ray);
      errors[ray].ulp =
          reference::parameter_error(exact, spheres[*got],
                                     exact.intersect(spheres[*got], trial.conventions()),
                                     hit->parameter, trial.precision())
              .value;
    }
  }
  return errors;
}

}  // namespace raycheck::properties
