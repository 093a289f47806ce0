#include <algorithm>

#include "properties/law_list.h"

namespace raycheck::properties {
namespace {

using Index = std::optional<std::size_t>;
using reference::NearestSphere;

/// The candidate's sphere and the exact one, both by the scene's order.
struct Choice {
  std::size_t ray;
  Index got;
  const std::optional<NearestSphere>& exact;
};

bool is_right(const Choice& choice) {
  if (!choice.exact) return !choice.got;
  return choice.got && std::find(choice.exact->ties.begin(), choice.exact->ties.end(),
                                 *choice.got) != choice.exact->ties.end();
}

/// A change of the inputs may flip the class of one of the two spheres, or their order.
bool may_flip(Trial& trial, const Choice& choice) {
  const auto& spheres = trial.scene().spheres;
  const reference::ExactRay& ray = trial.exact_ray(choice.ray);
  const auto class_may_flip = [&](std::size_t sphere) {
    return ray.may_flip_within(spheres[sphere], trial.conventions().root, trial.excused_change());
  };
  if (choice.got && class_may_flip(*choice.got)) return true;
  if (!choice.exact) return false;
  if (class_may_flip(choice.exact->index)) return true;
  if (!choice.got || !trial.exact_hit(choice.ray, *choice.got)) return false;
  const auto widened = ray.enclose(256, trial.excused_change());
  return (widened.parameter(spheres[*choice.got],
                            trial.exact_intersection(choice.ray, *choice.got)) -
          widened.parameter(spheres[choice.exact->index], choice.exact->intersection))
      .contains_zero();
}

/// The rays that meet a sphere in a tangent that is not judged.
std::vector<bool> with_unjudged(Trial& trial) {
  std::vector<bool> result(trial.ray_count());
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    for (const Meeting& meeting : trial.exact_meetings(sphere)) {
      if (is_unjudged(meeting.intersection, trial.conventions().tangent)) {
        result[meeting.ray] = true;
      }
    }
  }
  return result;
}

Verdict judge_nearest_sphere(Trial& trial) {
  if (!trial.candidate().nearest) return Verdict::left_out("the candidate ranks no spheres");
  if (trial.scene().spheres.empty()) return Verdict::left_out("the scene has no sphere");
  if (!trial.has_rays()) {
    return Verdict::left_out("the candidate makes no rays from this origin");
  }
  if (trial.scene().spheres.size() == 1) {
    return Verdict::left_out("the scene has one sphere: its class says it all");
  }
  const std::vector<scene::Sphere> reversed(trial.scene().spheres.rbegin(),
                                            trial.scene().spheres.rend());
  const auto backwards = trial.rank(trial.rays(), reversed);
  const std::vector<bool> is_left_out = with_unjudged(trial);
  Verdict verdict;
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    if (is_left_out[k]) continue;
    const auto& exact = trial.exact_nearest()[k];
    const Index last_first = backwards.at(k);
    const Index reversed_got = last_first ? Index(reversed.size() - 1 - *last_first) : Index();
    // One case a ray: right in both orders.
    Choice choice{k, trial.nearest()[k], exact};
    const bool right_forwards = is_right(choice);
    if (right_forwards) choice.got = reversed_got;
    const Wrong wrong = is_right(choice) ? Wrong::kNot
                        : !choice.exact  ? Wrong::kFalseHit
                        : !choice.got    ? Wrong::kMissed
                                         : Wrong::kWrongSphere;
    trial.judge(
        verdict, kNearestSphereLaw.name, Quantity::kNearestSphere,
        trial.place(k, exact ? Index(exact->index) : choice.got), wrong,
        [&] { return may_flip(trial, choice); },
        [&](Discrepancy& d) {
          d.what = right_forwards ? "sphere index, spheres in reverse order" : "sphere index";
          if (choice.got) d.got = {static_cast<double>(*choice.got)};
          if (exact) d.exact = {static_cast<double>(exact->index)};
        });
  }
  return verdict;
}

}  // namespace

constinit const Law kNearestSphereLaw = {"nearest-sphere",
                                         "the nearest sphere wins, whatever the order in the file",
                                         Law::Subject::kIntersection, true, judge_nearest_sphere};

}  // namespace raycheck::properties
