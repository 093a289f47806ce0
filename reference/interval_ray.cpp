#include "reference/interval_ray.h"

#include "reference/internal/formulas.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

using Pair = LineAndSphere<IntervalKernel>;

/// The intersection from the signs of the discriminant, of c and of b, as ExactRay has it: with c <
/// 0 the roots have opposite signs, with c > 0 both have b's sign, with c = 0 one of them is 0.
std::optional<Intersection> decide(const Pair& pair, const Interval& squared_root,
                                   scene::Root root) {
  const Intersection miss{};
  const std::optional<int> meets = certain_sign(squared_root);
  if (!meets) return std::nullopt;
  if (*meets < 0) return miss;
  const HitClass hit = *meets == 0 ? HitClass::kTangent : HitClass::kHit;
  const bool larger_counts = root == scene::Root::kNearest;
  const Intersection larger = larger_counts ? Intersection{hit, WhichRoot::kLarger} : miss;
  const std::optional<int> outside = certain_sign(constant_coefficient(pair));
  if (!outside) return std::nullopt;
  if (*outside < 0) return larger;
  const std::optional<int> ahead = certain_sign(linear_coefficient(pair));
  if (!ahead) return std::nullopt;
  if (*ahead > 0 || (*ahead == 0 && *outside == 0)) return Intersection{hit, WhichRoot::kSmaller};
  return *outside == 0 ? larger : miss;
}

}  // namespace

std::optional<IntervalIntersection> intersect_by_intervals(const scene::Ray& ray,
                                                           const scene::Sphere& sphere,
                                                           scene::Root root) {
  scene::require_valid(ray);
  scene::require_valid(sphere);
  const IntervalGuard guard;
  const IntervalLift lift;
  Line<IntervalKernel> line{};
  line.base = lift_vector<IntervalKernel>(lift, ray.origin);
  line.g = lift_vector<IntervalKernel>(lift, ray.direction);
  line.a = line.g * line.g;
  const Pair pair{line, lift_vector<IntervalKernel>(lift, sphere.centre) - line.base,
                  lift(sphere.radius)};
  const Interval squared_root = discriminant(pair);
  const std::optional<Intersection> found = decide(pair, squared_root, root);
  if (!found) return std::nullopt;
  if (found->hit_class == HitClass::kMiss) return IntervalIntersection{*found};
  Interval numerator = linear_coefficient(pair);
  if (found->hit_class == HitClass::kHit) {
    const Interval half = CGAL::sqrt(squared_root);
    numerator = found->root == WhichRoot::kSmaller ? numerator - half : numerator + half;
  }
  const Interval s = numerator / line.a;
  return IntervalIntersection{*found, s.inf(), s.sup()};
}

}  // namespace raycheck::reference
