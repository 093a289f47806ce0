#include "reference/interval_ray.h"

#include "reference/internal/classify.h"
#include "reference/internal/ray_impl.h"
#include "scene/validate.h"

namespace raycheck::reference {

std::optional<IntervalIntersection> intersect_by_intervals(const scene::Ray& ray,
                                                           const scene::Sphere& sphere,
                                                           scene::Root root) {
  scene::require_valid(ray);
  scene::require_valid(sphere);
  const IntervalGuard guard;
  const IntervalLift lift;
  const auto line = given_line(lift_ray(lift, ray));
  const auto pair = line_and_sphere(line, lift_sphere(lift, sphere));
  const Interval squared_root = discriminant(pair);
  const auto found = classify(
      [&](Coefficient coefficient) {
        return coefficient == Coefficient::kDiscriminant ? certain_sign(squared_root)
                                                         : sign_of(coefficient, pair);
      },
      root);
  if (!found) return std::nullopt;
  if (found->hit_class == HitClass::kMiss) return IntervalIntersection{*found};
  const Interval s = root_of(linear_coefficient(pair), squared_root, root_sign(*found)) / line.a;
  return IntervalIntersection{*found, s.inf(), s.sup()};
}

}  // namespace raycheck::reference
