// The conditioning of each step that `explain` derives.

#include <algorithm>

#include "reference/account/condition.h"
#include "tools/explain/explain_methods.h"

namespace raycheck::tools {
namespace {

/// Sets kappa of the step with this symbol, end to end and of the step alone.
void note(std::vector<Step>& steps, const char* symbol, std::optional<double> end_to_end,
          std::optional<double> alone) {
  const auto step = std::find_if(steps.begin(), steps.end(),
                                 [&](const Step& one) { return one.symbol == symbol; });
  if (step == steps.end()) return;
  step->condition = end_to_end;
  step->condition_alone = alone;
}

}  // namespace

void add_ray_conditions(const Subject& subject, const reference::ExactCamera* camera,
                        std::vector<Step>& steps) {
  const reference::RayStageConditions alone = reference::stage_conditions(subject.exact);
  if (camera != nullptr) {
    const double frame = reference::condition_of_frame(*camera);
    for (const char* axis : {"W", "U", "V"}) note(steps, axis, frame, {});
    note(steps, "P", reference::condition_of_pixel_point(subject.exact), alone.pixel_point);
  }
  note(steps, "D", reference::condition_of_direction(subject.exact), alone.direction);
}

void add_sphere_conditions(const Subject& subject, const scene::Sphere& sphere,
                           const reference::Intersection& intersection, std::vector<Step>& steps) {
  const reference::ExactRay& ray = subject.exact;
  const auto alone = reference::stage_conditions(ray, sphere, intersection);
  note(steps, "v", reference::condition_of_axial_distance(ray, sphere), alone.axial_distance);
  note(steps, "d^2", reference::condition_of_half_chord_sq(ray, sphere), alone.half_chord_sq);
  if (intersection.hit_class == reference::HitClass::kMiss) return;
  note(steps, "s", reference::condition_of_parameter(ray, sphere, intersection), alone.root);
  note(steps, "Q", reference::condition_of_point(ray, sphere, intersection), alone.point);
}

}  // namespace raycheck::tools
