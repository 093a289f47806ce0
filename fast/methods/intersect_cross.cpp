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

bool batch(const BatchQuestion& question, const HitArrays& answers) {
  return answer_batch(answer_whole_vectors<FromRoots<Cross<Lanes>>>, question, answers);
}

}  // namespace
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
namespace {

HWY_EXPORT(batch);

void intersect(const Rays& rays, const scene::Sphere& sphere, scene::Root root,
               scene::Tangent tangent, Hits& hits) {
  intersect_by(HWY_DYNAMIC_DISPATCH(batch), rays, sphere, root, tangent, hits);
}

using One = HWY_NAMESPACE::FromRoots<HWY_NAMESPACE::Cross<double>>;

}  // namespace

const IntersectMethod kCross = {
    .name = "cross",
    .sentence = "disc = a r^2 - |T x d|^2 with Kahan's products, roots by q",
    .intersect = intersect,
    .intersect_one = HWY_NAMESPACE::intersect_one<One>,
    .roots = HWY_NAMESPACE::roots_of<One>,
    .max_ulp = kCrossMaxUlp,
    .max_point_ulp = kCrossMaxPointUlp,
};

}  // namespace raycheck::fast
#endif
