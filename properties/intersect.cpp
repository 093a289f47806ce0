#include <cmath>

#include "properties/law_list.h"
#include "reference/condition.h"
#include "reference/error_measure.h"

namespace raycheck::properties {
namespace {

using reference::Enclosure;
using reference::Enclosure3;
using reference::ExactRay;
using reference::Intersection;

std::string nothing_to_say(const Trial& trial) {
  if (!trial.candidate().intersect) return "the candidate intersects nothing";
  if (trial.scene().spheres.empty()) return "the scene has no sphere";
  if (!trial.has_rays()) return "the candidate makes no rays from this origin";
  return {};
}

/// Calls visit(ray, sphere, answer) for every judged pair.
template <class Visit>
void for_each_pair(Trial& trial, Visit visit) {
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const auto& hits = trial.hits(sphere);
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      if (!trial.is_unjudged(ray, sphere)) visit(ray, sphere, hits[ray]);
    }
  }
}

/// An answer within this share of the distance between the two exact roots is at the root it is
/// near.
constexpr int kRootShare = 4;

/// At the exact ray's other root: an answer somewhere between the two is an error of the parameter.
bool is_other_root(Trial& trial, std::size_t ray, std::size_t sphere, double parameter) {
  const Intersection& right = trial.exact_intersection(ray, sphere);
  if (right.hit_class == reference::HitClass::kTangent || !std::isfinite(parameter)) return false;
  Intersection other = right;
  other.root = right.root == reference::WhichRoot::kSmaller ? reference::WhichRoot::kLarger
                                                            : reference::WhichRoot::kSmaller;
  const auto enclosed = trial.exact_ray(ray).enclose(256);
  const scene::Sphere& the_sphere = trial.scene().spheres[sphere];
  const Enclosure other_root = enclosed.parameter(the_sphere, other);
  const Enclosure apart = abs(other_root - enclosed.parameter(the_sphere, right));
  const Enclosure off = abs(Enclosure(parameter, 256) - other_root);
  return (apart - Enclosure(kRootShare) * off).certain_sign() == 1;
}

/// Calls visit(ray, sphere, answer) where both the candidate and the truth have a hit, at one root.
template <class Visit>
void for_each_common_hit(Trial& trial, Visit visit) {
  for_each_pair(trial,
                [&](std::size_t ray, std::size_t sphere, const std::optional<HitAnswer>& answer) {
                  if (!answer || !trial.exact_hit(ray, sphere)) return;
                  if (is_other_root(trial, ray, sphere, answer->parameter)) return;
                  visit(ray, sphere, *answer);
                });
}

bool may_flip(Trial& trial, std::size_t ray, std::size_t sphere) {
  return trial.exact_ray(ray).may_flip_within(trial.scene().spheres[sphere],
                                              trial.conventions().root, trial.excused_change());
}

void describe_parameters(Trial& trial, std::size_t ray, std::size_t sphere,
                         const std::optional<HitAnswer>& answer, Discrepancy& d) {
  if (answer) d.got = {answer->parameter};
  if (trial.exact_hit(ray, sphere)) {
    d.exact = {trial.exact_ray(ray).rounded_parameter(trial.scene().spheres[sphere],
                                                      trial.exact_intersection(ray, sphere))};
  }
}

/// The backward error of an answer, for the very ray that the candidate was asked about.
double backward_error(Trial& trial, std::size_t ray, std::size_t sphere, const HitAnswer& answer) {
  return reference::backward_error(trial.rays()[ray], trial.scene().spheres[sphere],
                                   answer.parameter);
}

Verdict judge_class(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  Verdict verdict;
  for_each_pair(trial,
                [&](std::size_t ray, std::size_t sphere, const std::optional<HitAnswer>& answer) {
                  const bool exact = trial.exact_hit(ray, sphere);
                  const Wrong wrong = exact == answer.has_value() ? Wrong::kNot
                                      : exact                     ? Wrong::kMissed
                                                                  : Wrong::kFalseHit;
                  trial.judge(
                      verdict, kClassLaw.name, Quantity::kClass, trial.place(ray, sphere), wrong,
                      [&] { return may_flip(trial, ray, sphere); },
                      [&](Discrepancy& d) { describe_parameters(trial, ray, sphere, answer, d); });
                });
  std::size_t unjudged = 0;
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      unjudged += trial.is_unjudged(ray, sphere) ? 1 : 0;
    }
  }
  if (unjudged > 0) verdict.leave_out("exactly tangent pairs: tangent = either");
  return verdict;
}

Verdict judge_root(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  Verdict verdict;
  for_each_pair(
      trial, [&](std::size_t ray, std::size_t sphere, const std::optional<HitAnswer>& answer) {
        if (!answer || !trial.exact_hit(ray, sphere)) return;
        const Wrong wrong =
            is_other_root(trial, ray, sphere, answer->parameter) ? Wrong::kWrongRoot : Wrong::kNot;
        trial.judge(
            verdict, kRootLaw.name, Quantity::kRoot, trial.place(ray, sphere), wrong,
            [&] { return may_flip(trial, ray, sphere); },
            [&](Discrepancy& d) { describe_parameters(trial, ray, sphere, answer, d); });
      });
  return verdict;
}

Verdict judge_parameter(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  Verdict verdict;
  for_each_common_hit(trial, [&](std::size_t ray, std::size_t sphere, const HitAnswer& answer) {
    trial.measure(
        verdict, kParameterLaw.name, Quantity::kParameter, trial.place(ray, sphere),
        reference::ulp_error(answer.parameter, trial.exact_parameter(ray, sphere)),
        trial.bound(Quantity::kParameter),
        [&] { return trial.condition_of_parameter(ray, sphere); },
        [&](Discrepancy& d) { describe_parameters(trial, ray, sphere, answer, d); },
        [&] { return backward_error(trial, ray, sphere, answer); });
  });
  return verdict;
}

Verdict judge_backward_error(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  Verdict verdict;
  for_each_common_hit(trial, [&](std::size_t ray, std::size_t sphere, const HitAnswer& answer) {
    // It is a change of the inputs already: no condition number magnifies it.
    trial.measure(
        verdict, kBackwardErrorLaw.name, Quantity::kBackwardError, trial.place(ray, sphere),
        backward_error(trial, ray, sphere, answer), [] { return 1; },
        [&](Discrepancy& d) { d.got = {answer.parameter}; });
  });
  return verdict;
}

/// How the candidate's point is off its sphere and its ray, in units of u of r and of s |D|. Both
/// are differences of world coordinates, so their condition is the size of those over r and s |D|.
void judge_residuals(Trial& trial, Verdict& verdict, std::size_t ray, std::size_t sphere,
                     const HitAnswer& answer) {
  const scene::Sphere& the_sphere = trial.scene().spheres[sphere];
  const reference::EnclosedRay exact = trial.exact_ray(ray).enclose(256);
  const Enclosure3 point = reference::enclose_exactly(answer.point);
  const Enclosure3 centre = reference::enclose_exactly(the_sphere.centre);
  const Enclosure radius(the_sphere.radius, 256);
  const Enclosure size = norm(point) + norm(centre) + norm(exact.origin()) + radius;
  const double point_condition = reference::condition_of_point(
      trial.exact_ray(ray), the_sphere, trial.exact_intersection(ray, sphere));
  const auto measure = [&](Quantity quantity, const Enclosure& distance, const Enclosure& scale) {
    const double error = scale.contains_zero() ? 0 : reference::in_units_of_u(distance / scale);
    if (scale.contains_zero()) return;
    trial.measure(
        verdict, kHitPointLaw.name, quantity, trial.place(ray, sphere), error,
        [&] { return (size / scale).upper() * point_condition; },
        [&](Discrepancy& d) { d.got = numbers(answer.point); });
  };
  measure(Quantity::kSphereResidual, abs(norm(point - centre) - radius), radius);
  const Enclosure3 along = point - exact.origin();
  measure(Quantity::kRayResidual, norm(cross(along, exact.direction())), norm(along));
}

Verdict judge_hit_point(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  Verdict verdict;
  for_each_common_hit(trial, [&](std::size_t ray, std::size_t sphere, const HitAnswer& answer) {
    const ExactRay& exact_ray = trial.exact_ray(ray);
    const scene::Sphere& the_sphere = trial.scene().spheres[sphere];
    const Intersection& at = trial.exact_intersection(ray, sphere);
    trial.measure(
        verdict, kHitPointLaw.name, Quantity::kHitPoint, trial.place(ray, sphere),
        reference::relative_error(answer.point, exact_ray.point(the_sphere, at)),
        // Every method adds s D to L, a step that loses |L|/|Q| of its own.
        [&] {
          return reference::condition_of_point(exact_ray, the_sphere, at) +
                 *reference::stage_conditions(exact_ray, the_sphere, at).point;
        },
        [&](Discrepancy& d) {
          d.got = numbers(answer.point);
          d.exact = numbers(exact_ray.rounded_point(the_sphere, at));
        });
    judge_residuals(trial, verdict, ray, sphere, answer);
  });
  return verdict;
}

/// The same point from both origins: s from the eye is s from the pixel point plus l.
Verdict judge_focal_and_pixel(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  if (!trial.scene().camera) return Verdict::left_out("the scene has no camera");
  const Candidate& candidate = trial.candidate();
  if (!candidate.pixel_rays || !candidate.focal_rays) {
    return Verdict::left_out("the candidate has rays from one origin only");
  }
  scene::Conventions from_pixel = trial.conventions();
  from_pixel.origin = scene::Origin::kPixel;
  scene::Conventions from_eye = from_pixel;
  from_eye.origin = scene::Origin::kFocal;
  const scene::Camera& camera = *trial.scene().camera;
  const reference::ExactCamera pixel_camera(camera, from_pixel);
  const reference::ExactCamera eye_camera(camera, from_eye);
  const auto pixel_rays = candidate.pixel_rays(camera, from_pixel, trial.pixels());
  const auto eye_rays = candidate.focal_rays(camera, from_eye, trial.pixels());
  Verdict verdict;
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const scene::Sphere& the_sphere = trial.scene().spheres[sphere];
    const auto pixel_hits = trial.intersect(pixel_rays, the_sphere, from_pixel);
    const auto eye_hits = trial.intersect(eye_rays, the_sphere, from_eye);
    for (std::size_t k = 0; k < trial.ray_count(); ++k) {
      const ExactRay pixel_ray(pixel_camera, trial.pixels()[k]);
      const ExactRay eye_ray(eye_camera, trial.pixels()[k]);
      const Intersection at = eye_ray.intersect(the_sphere, from_eye.root);
      // Another root or class from the pixel: the sphere reaches behind it.
      if (at.hit_class != reference::HitClass::kHit ||
          !(at == pixel_ray.intersect(the_sphere, from_pixel.root))) {
        continue;
      }
      if (!pixel_hits[k] || !eye_hits[k]) continue;  // for the class law
      const auto enclosed = eye_ray.enclose(256);
      const Enclosure off = Enclosure(eye_hits[k]->parameter, 256) -
                            Enclosure(pixel_hits[k]->parameter, 256) - enclosed.length();
      const Enclosure scale = enclosed.parameter(the_sphere, at);
      const auto condition = [&] {
        return reference::condition_of_parameter(eye_ray, the_sphere, at) +
               reference::condition_of_point(eye_ray, the_sphere, at);
      };
      const auto describe = [&](Discrepancy& d) {
        d.what = "s from the eye, s from the pixel";
        d.got = {eye_hits[k]->parameter, pixel_hits[k]->parameter};
        d.exact = {eye_ray.rounded_parameter(the_sphere, at),
                   pixel_ray.rounded_parameter(the_sphere, at)};
      };
      trial.measure(verdict, kFocalAndPixelLaw.name, Quantity::kInvariance, trial.place(k, sphere),
                    reference::in_units_of_u(off / scale), 2 * trial.bound(Quantity::kParameter),
                    condition, describe);
      const Enclosure3 apart = reference::enclose_exactly(eye_hits[k]->point) -
                               reference::enclose_exactly(pixel_hits[k]->point);
      const Enclosure size = norm(enclosed.point(the_sphere, at)) + norm(enclosed.origin());
      trial.measure(verdict, kFocalAndPixelLaw.name, Quantity::kInvariance, trial.place(k, sphere),
                    reference::in_units_of_u(norm(apart) / size),
                    2 * trial.bound(Quantity::kHitPoint), condition, describe);
    }
  }
  if (verdict.compared() == 0) {
    return Verdict::left_out("no sphere is met at one root from both origins");
  }
  return verdict;
}

}  // namespace

constinit const Law kClassLaw = {"class", "hit or miss as the exact class says",
                                 Law::Subject::kIntersection, true, judge_class};
constinit const Law kRootLaw = {"nearest-root",
                                "the root is the right one: no exact root lies in [0, s)",
                                Law::Subject::kIntersection, true, judge_root};
constinit const Law kParameterLaw = {"parameter", "the parameter s is the exact root's",
                                     Law::Subject::kIntersection, true, judge_parameter};
constinit const Law kBackwardErrorLaw = {
    "backward-error", "the parameter s is the exact root for inputs changed by a few roundings",
    Law::Subject::kIntersection, false, judge_backward_error};
constinit const Law kHitPointLaw = {"hit-point",
                                    "the hit point is exact, lies on the sphere and on the ray",
                                    Law::Subject::kIntersection, true, judge_hit_point};
constinit const Law kFocalAndPixelLaw = {
    "focal-and-pixel", "focal and pixel origins find the same point, parameters l apart",
    Law::Subject::kCameraAndIntersection, false, judge_focal_and_pixel};

}  // namespace raycheck::properties
