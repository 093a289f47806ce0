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

  static RootsOf<N> roots(const Triple<N>& origin, const Triple<N>& direction,
                          const Triple<N>& centre, N radius) {
    const Triple<N> T = centre - origin;
    const N a = dot(direction, direction);
    const N b = dot(T, direction);
    const N c = dot(T, T) - radius * radius;
    const Triple<N> moment = {difference_of_products(T.y, direction.z, T.z, direction.y),
                              difference_of_products(T.z, direction.x, T.x, direction.z),
                              difference_of_products(T.x, direction.y, T.y, direction.x)};
    return roots_by_q<N>(a, b, c, a * (radius * radius) - dot(moment, moment));
  }
};

}  // namespace
RAYCHECK_BATCH_OF(Cross)
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
RAYCHECK_INTERSECT_BY(Cross)

/// disc = |d|^2 r^2 - |T x d|^2 with Kahan's products; roots by q.
const IntersectMethod kCross = {
    .name = "cross",
    .sentence = "disc = a r^2 - |T x d|^2 with Kahan's products, roots by q",
    RAYCHECK_FUNCTIONS,
    .max_ulp = 88,
    .max_point_ulp = 104,
};

}  // namespace raycheck::fast
#endif
