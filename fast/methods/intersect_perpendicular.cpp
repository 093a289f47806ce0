#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_perpendicular.cpp"
#include <hwy/foreach_target.h>

#include "fast/internal/intersect_batch.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

/// Uses the distance from the centre to the line instead of a difference of two large squares
/// (Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019,
/// after Hearn and Baker).
template <class N>
struct Perpendicular {
  using Number = N;

  static RootsOf<N> roots(const RayOf<N>& ray, const SphereOf<N>& sphere) {
    const auto& [T, a, b, c] = quadratic(ray, sphere);
    const Triple<N> off_line = T - (b / a) * ray.direction;
    return roots_by_q<N>(a, b, c, a * (sphere.radius * sphere.radius - dot(off_line, off_line)));
  }
};

}  // namespace
RAYCHECK_BATCH_OF(Perpendicular)
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
RAYCHECK_INTERSECT_BY(Perpendicular)

/// disc from |T - (T.D) D|^2, which does not cancel; roots by q.
const IntersectMethod kPerpendicular = {
    .name = "perpendicular",
    .sentence = "disc = a (r^2 - |T - (b/a) D|^2), roots by q",
    RAYCHECK_FUNCTIONS(Perpendicular),
    .classes_in = HWY_NAMESPACE::classes_in<HWY_NAMESPACE::Perpendicular>,
    .max_ulp = 96,
    .max_point_ulp = 112,
};

}  // namespace raycheck::fast
#endif
