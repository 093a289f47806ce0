#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/ray_error.h"

namespace raycheck::properties {

double plain_condition(const Candidate& candidate, const reference::ExactRay& ray) {
  if (candidate.level != Level::kOrdinary) return 0;
  const double condition = reference::stage_conditions(ray).direction;
  return condition <= kOrdinaryDistance ? condition : 0;
}

namespace {

scene::UnitVector3 direction_of(const scene::Ray& ray) {
  return {ray.direction.x, ray.direction.y, ray.direction.z};
}

void judge_unit_direction(Trial& trial, Verdict& verdict) {
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const scene::UnitVector3 got = direction_of(trial.rays()[k]);
    // A direction computed from the axes inherits their error.
    trial.measure(
        verdict, {Quantity::kUnitDefect, trial.place(k), reference::unit_defect(got)},
        [&] { return reference::condition_of_frame(trial.exact_camera()); },
        [&](Discrepancy& d) {
          d.got = numbers(got);
          d.exact = numbers(trial.exact_ray(k).rounded_direction(trial.precision()));
        });
  }
}

void judge_direction(Trial& trial, Verdict& verdict) {
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const reference::ExactRay& ray = trial.exact_ray(k);
    const scene::UnitVector3 got = direction_of(trial.rays()[k]);
    trial.measure(
        verdict, {Quantity::kDirection, trial.place(k), reference::direction_error(ray, got)},
        [&] { return reference::condition_of_direction(ray); },
        [&](Discrepancy& d) {
          d.got = numbers(got);
          d.exact = numbers(ray.rounded_direction(trial.precision()));
        },
        {}, [&] { return plain_condition(trial.candidate(), ray); });
  }
}

void judge_ray_origin(Trial& trial, Verdict& verdict) {
  const bool at_eye = trial.conventions().origin == scene::Origin::kFocal;
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const reference::ExactRay& ray = trial.exact_ray(k);
    const scene::Point3& got = trial.rays()[k].origin;
    trial.measure(
        verdict, {Quantity::kRayOrigin, trial.place(k), reference::origin_error(ray, got)},
        [&] { return at_eye ? 1 : reference::condition_of_pixel_point(ray); },
        [&](Discrepancy& d) {
          d.got = numbers(got);
          d.exact = numbers(ray.rounded_origin(trial.precision()));
        });
  }
}

constexpr Law kPixelRayLawTable[] = {
    {.name = "unit-direction",
     .sentence = "directions have length 1",
     .per = Per::kRay,
     .needs = Needs::kMadeRays,
     .quantity = Quantity::kUnitDefect,
     .judges_values = true,
     .stage = Stage::kRays,
     .judge = judge_unit_direction},
    {.name = "direction",
     .sentence = "directions run from the eye through the pixel",
     .per = Per::kRay,
     .needs = Needs::kMadeRays,
     .quantity = Quantity::kDirection,
     .judges_values = true,
     .stage = Stage::kRays,
     .tells_stability = true,
     .judge = judge_direction},
    {.name = "ray-origin",
     .sentence = "rays start where the origin convention says",
     .per = Per::kRay,
     .needs = Needs::kMadeRays,
     .quantity = Quantity::kRayOrigin,
     .judges_values = true,
     .stage = Stage::kRays,
     .judge = judge_ray_origin},
};

}  // namespace

constinit const std::span<const Law> kPixelRayLaws = kPixelRayLawTable;

}  // namespace raycheck::properties
