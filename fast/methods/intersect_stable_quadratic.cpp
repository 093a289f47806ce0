#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_stable_quadratic.cpp"
#include <hwy/foreach_target.h>

#include "fast/internal/intersect_batch.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

template <class N>
struct StableQuadratic {
  using Number = N;

  static RootsOf<N> roots(const RayOf<N>& ray, const SphereOf<N>& sphere) {
    const auto& [T, a, b, c] = quadratic(ray, sphere);
    return roots_by_q<N>(a, b, c, b * b - a * c);
  }
};

}  // namespace
RAYCHECK_BATCH_OF(StableQuadratic)
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
RAYCHECK_INTERSECT_BY(StableQuadratic)

/// The coefficients of `quadratic`; roots by q = b + sign(b) sqrt(disc).
const IntersectMethod kStableQuadratic = {
    .name = "stable-quadratic",
    .sentence = "disc = b^2 - ac, q = b + sign(b) sqrt(disc), roots q/a and c/q",
    RAYCHECK_FUNCTIONS(StableQuadratic),
    .classes_in = HWY_NAMESPACE::classes_in<HWY_NAMESPACE::StableQuadratic>,
    .max_ulp = 128,
    .max_point_ulp = 160,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
#endif
