#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_kahan.cpp"
#include <hwy/foreach_target.h>

#include "fast/internal/error_free.h"
#include "fast/internal/intersect_batch.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

/// The discriminant of the rounded coefficients to a few ulp (Kahan, On the Cost of Floating-Point
/// Computation Without Extra-Precise Arithmetic, 2004). The errors of b and c remain.
template <class N>
struct Kahan {
  using Number = N;

  static RootsOf<N> roots(const RayOf<N>& ray, const SphereOf<N>& sphere) {
    const auto& [T, a, b, c] = quadratic(ray, sphere);
    return roots_by_q<N>(a, b, c, difference_of_products(b, b, a, c));
  }
};

}  // namespace
RAYCHECK_BATCH_OF(Kahan)
RAYCHECK_ONE_OF(Kahan)
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
RAYCHECK_INTERSECT_BY(Kahan)
RAYCHECK_ONE_BY_BEST(Kahan)

/// Like `quadratic`, but the discriminant is Kahan's difference of products.
const IntersectMethod kKahan = {
    .name = "kahan",
    .sentence = "the textbook's a, b, c; disc = b^2 - ac by Kahan's products, roots by q",
    RAYCHECK_FUNCTIONS_BY_BEST(Kahan),
    .max_ulp = 128,
    .max_point_ulp = 160,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
#endif
