#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_cross2.cpp"
#include <hwy/foreach_target.h>

#include "fast/internal/error_free.h"
#include "fast/internal/intersect_batch.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

/// x y - z w, a component of a cross product. x and z are pairs of doubles.
template <class N>
N determinant(const Rounded<N>& x, N y, const Rounded<N>& z, N w) {
  return difference_of_products(x.x, y, z.x, w) + (x.error * y - z.error * w);
}

/// `cross` with T = C - o as exact pairs and c = |T|^2 - r^2 as a compensated sum (Ogita, Rump and
/// Oishi, Accurate sum and dot product, 2005). No digits are lost by rounding T or near the
/// surface.
template <class N>
struct Cross2 {
  using Number = N;

  static RootsOf<N> roots(const RayOf<N>& ray, const SphereOf<N>& sphere) {
    const auto& [origin, direction] = ray;
    const Triple<N>& centre = sphere.centre;
    const Rounded<N> x = two_difference(centre.x, origin.x);
    const Rounded<N> y = two_difference(centre.y, origin.y);
    const Rounded<N> z = two_difference(centre.z, origin.z);
    const Triple<N> T = {x.x, y.x, z.x};
    const Triple<N> T_error = {x.error, y.error, z.error};
    const N a = dot(direction, direction);
    const N b = dot(T, direction) + dot(T_error, direction);
    const Triple<N> moment = {determinant(y, direction.z, z, direction.y),
                              determinant(z, direction.x, x, direction.z),
                              determinant(x, direction.y, y, direction.x)};
    const Rounded<N> xx = two_square(x.x);
    const Rounded<N> yy = two_square(y.x);
    const Rounded<N> zz = two_square(z.x);
    const Rounded<N> rr = two_square(sphere.radius);
    const Rounded<N> first = two_difference(xx.x, rr.x);
    const Rounded<N> second = two_sum(first.x, yy.x);
    const Rounded<N> sum = two_sum(second.x, zz.x);
    const N c = sum.x + ((first.error + second.error + sum.error) +
                         (xx.error + yy.error + zz.error - rr.error) + N(2) * dot(T, T_error));
    return roots_by_q<N>(a, b, c, a * rr.x - dot(moment, moment));
  }
};

}  // namespace
RAYCHECK_BATCH_OF(Cross2)
RAYCHECK_ONE_OF(Cross2)
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
RAYCHECK_INTERSECT_BY(Cross2)
RAYCHECK_ONE_BY_BEST(Cross2)

/// `cross` with T as exact pairs and c = |T|^2 - r^2 as a compensated sum.
const IntersectMethod kCross2 = {
    .name = "cross2",
    .sentence = "cross, with C - L as an exact pair and a compensated c",
    RAYCHECK_FUNCTIONS_BY_BEST(Cross2),
    .max_ulp = 88,
    .max_point_ulp = 104,
};

}  // namespace raycheck::fast
#endif
