#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_cross.cpp"
#include <hwy/foreach_target.h>

#include "fast/internal/error_free.h"
#include "fast/internal/intersect_batch.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

/// Lagrange's identity: b^2 - a c = a r^2 - |T x d|^2, whose terms cancel only near tangency.
template <class N>
struct Cross {
  using Number = N;

  static RootsOf<N> roots(const RayOf<N>& ray, const SphereOf<N>& sphere) {
    const auto& [T, a, b, c] = quadratic(ray, sphere);
    const Triple<N> moment = {difference_of_products(T.y, ray.direction.z, T.z, ray.direction.y),
                              difference_of_products(T.z, ray.direction.x, T.x, ray.direction.z),
                              difference_of_products(T.x, ray.direction.y, T.y, ray.direction.x)};
    return roots_by_q<N>(a, b, c, a * (sphere.radius * sphere.radius) - dot(moment, moment));
  }
};

}  // namespace
RAYCHECK_BATCH_OF(Cross)
RAYCHECK_ONE_OF(Cross)
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
RAYCHECK_INTERSECT_BY(Cross)
RAYCHECK_ONE_BY_BEST(Cross)

/// disc = |d|^2 r^2 - |T x d|^2 with Kahan's products; roots by q.
const IntersectMethod kCross = {
    .name = "cross",
    .sentence = "disc = a r^2 - |T x D|^2 with Kahan's products, roots by q",
    RAYCHECK_FUNCTIONS_BY_BEST(Cross),
    .max_ulp = 88,
    .max_point_ulp = 104,
};

}  // namespace raycheck::fast
#endif
