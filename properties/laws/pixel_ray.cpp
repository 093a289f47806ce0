#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/ray_error.h"

namespace raycheck::properties {

double plain_condition(const Candidate& candidate, const ExactRay& ray) {
  if (candidate.level != Level::kOrdinary) return 0;
  const double condition = reference::stage_conditions(ray).direction;
  return condition <= kOrdinaryDistance ? condition : 0;
}

namespace {

scene::UnitVector3 direction_of(const Ray& ray) {
  return {ray.direction.x, ray.direction.y, ray.direction.z};
}

void judge_unit_direction(Trial& trial, Verdict& verdict) {
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const scene::UnitVector3 got = direction_of(trial.rays()[k]);
    // A direction computed from the axes inherits their error.
    trial.measure(
        verdict, {Quantity::kUnitDefect, trial.place(k), reference::unit_defect(got)},
        [&] { return reference::condition_of_frame(trial.exact_camera()); },
        shown(got, [&] { return trial.exact_ray(k).rounded_direction(trial.precision()); }));
  }
}

void judge_direction(Trial& trial, Verdict& verdict) {
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const ExactRay& ray = trial.exact_ray(k);
    const scene::UnitVector3 got = direction_of(trial.rays()[k]);
    trial.measure(
        verdict, {Quantity::kDirection, trial.place(k), reference::direction_error(ray, got)},
        [&] { return reference::condition_of_direction(ray); },
        shown(got, [&] { return ray.rounded_direction(trial.precision()); }), {},
        [&] { return plain_condition(trial.candidate(), ray); });
  }
}

void judge_ray_origin(Trial& trial, Verdict& verdict) {
  const bool at_eye = trial.conventions().origin == scene::Origin::kFocal;
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const ExactRay& ray = trial.exact_ray(k);
    const Point3& got = trial.rays()[k].origin;
    trial.measure(
        verdict, {Quantity::kRayOrigin, trial.place(k), reference::origin_error(ray, got)},
        [&] { return at_eye ? 1 : reference::condition_of_pixel_point(ray); },
        shown(got, [&] { return ray.rounded_origin(trial.precision()); }));
  }
}

constexpr Law kPixelRayLawTable[] = {
    {"unit-direction", "directions have length 1", Per::kRay, Needs::kMadeRays,
     Quantity::kUnitDefect, judge_unit_direction, kValues, Stage::kRays},
    {"direction", "directions run from the eye through the pixel", Per::kRay, Needs::kMadeRays,
     Quantity::kDirection, judge_direction, kValues, Stage::kRays, kStability},
    {"ray-origin", "rays start where the origin convention says", Per::kRay, Needs::kMadeRays,
     Quantity::kRayOrigin, judge_ray_origin, kValues, Stage::kRays},
};

}  // namespace

constinit const std::span<const Law> kPixelRayLaws = kPixelRayLawTable;

}  // namespace raycheck::properties
