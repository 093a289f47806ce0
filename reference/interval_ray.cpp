#include "reference/interval_ray.h"

#include <algorithm>

#include "reference/internal/classify.h"
#include "reference/internal/ray_impl.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

/// Lifts an input to the interval of all numbers within a relative change.
struct WideLift {
  using Kernel = IntervalKernel;
  Interval factor;
  explicit WideLift(double relative_change)
      : factor(Interval(1) + Interval(-relative_change, relative_change)) {}
  Interval operator()(double value) const { return Interval(value) * factor; }
  Interval constant(double value) const { return Interval(value); }
};

using Vector = IntervalKernel::Vector_3;

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}
Vector hull(const Vector& a, const Vector& b) {
  return {hull(a.x(), b.x()), hull(a.y(), b.y()), hull(a.z(), b.z())};
}

}  // namespace

std::optional<Intersection> intersection_in(const scene::Box<scene::Ray>& rays,
                                            const scene::Box<scene::Sphere>& spheres,
                                            double relative_change, scene::Root root) {
  for (const scene::Ray& ray : {rays.least, rays.greatest}) scene::require_valid(ray);
  for (const scene::Sphere& sphere : {spheres.least, spheres.greatest})
    scene::require_valid(sphere);
  const IntervalGuard guard;
  const WideLift lift(relative_change);
  const auto least = lift_ray(lift, rays.least), greatest = lift_ray(lift, rays.greatest);
  const auto small = lift_sphere(lift, spheres.least), large = lift_sphere(lift, spheres.greatest);
  const auto line = given_line<IntervalKernel>(
      {hull(least.origin, greatest.origin), hull(least.direction, greatest.direction)});
  const auto pair = line_and_sphere<IntervalKernel>(
      line, {hull(small.centre, large.centre), hull(small.radius, large.radius)});
  return classify([&](Coefficient coefficient) { return sign_of(coefficient, pair); }, root);
}

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
