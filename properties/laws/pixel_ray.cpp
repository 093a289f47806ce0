#include "properties/laws/law_list.h"
#include "reference/condition.h"
#include "reference/error_measure.h"
#include "reference/ray_error.h"

namespace raycheck::properties {
namespace {

std::string nothing_to_say(const Trial& trial) {
  if (!trial.scene().camera) return "the rays are given, not made from a camera";
  if (!trial.has_rays()) return "the candidate makes no rays from this origin";
  return {};
}

scene::UnitVector3 direction_of(const scene::Ray& ray) {
  return {ray.direction.x, ray.direction.y, ray.direction.z};
}

Verdict judge_unit_direction(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  Verdict verdict;
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const scene::UnitVector3 got = direction_of(trial.rays()[k]);
    // The axes' own defect passes into a direction that trusts them.
    trial.measure(
        verdict, kUnitDirectionLaw.name, Quantity::kUnitDefect, trial.place(k),
        reference::unit_defect(got),
        [&] { return reference::condition_of_frame(trial.exact_camera()); },
        [&](Discrepancy& d) {
          d.got = numbers(got);
          d.exact = numbers(trial.exact_ray(k).rounded_direction());
        });
  }
  return verdict;
}

Verdict judge_direction(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  Verdict verdict;
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const reference::ExactRay& ray = trial.exact_ray(k);
    const scene::UnitVector3 got = direction_of(trial.rays()[k]);
    trial.measure(
        verdict, kDirectionLaw.name, Quantity::kDirection, trial.place(k),
        reference::direction_error(ray, got),
        [&] { return reference::condition_of_direction(ray); },
        [&](Discrepancy& d) {
          d.got = numbers(got);
          d.exact = numbers(ray.rounded_direction());
        });
  }
  return verdict;
}

Verdict judge_ray_origin(Trial& trial) {
  if (auto reason = nothing_to_say(trial); !reason.empty()) return Verdict::left_out(reason);
  Verdict verdict;
  const bool at_eye = trial.conventions().origin == scene::Origin::kFocal;
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const reference::ExactRay& ray = trial.exact_ray(k);
    const scene::Point3& got = trial.rays()[k].origin;
    trial.measure(
        verdict, kRayOriginLaw.name, Quantity::kRayOrigin, trial.place(k),
        reference::origin_error(ray, got),
        [&] { return at_eye ? 1 : reference::condition_of_pixel_point(ray); },
        [&](Discrepancy& d) {
          d.got = numbers(got);
          d.exact = numbers(ray.rounded_origin());
        });
  }
  return verdict;
}

}  // namespace

constinit const Law kUnitDirectionLaw = {"unit-direction", "directions are unit",
                                         Law::Subject::kCamera, true, judge_unit_direction};
constinit const Law kDirectionLaw = {"direction", "directions run from the eye through the pixel",
                                     Law::Subject::kCamera, true, judge_direction};
constinit const Law kRayOriginLaw = {"ray-origin", "rays start where the origin convention says",
                                     Law::Subject::kCamera, true, judge_ray_origin};

}  // namespace raycheck::properties
