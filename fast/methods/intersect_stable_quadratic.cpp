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

  static RootsOf<N> roots(const Triple<N>& origin, const Triple<N>& direction,
                          const Triple<N>& centre, N radius) {
    const Triple<N> T = centre - origin;
    const N a = dot(direction, direction);
    const N b = dot(T, direction);
    const N c = dot(T, T) - radius * radius;
    return roots_by_q<N>(a, b, c, b * b - a * c);
  }
};

bool batch(const BatchQuestion& question, const HitArrays& answers) {
  return answer_batch(answer_whole_vectors<FromRoots<StableQuadratic<Lanes>>>, question, answers);
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

using One = HWY_NAMESPACE::FromRoots<HWY_NAMESPACE::StableQuadratic<double>>;

}  // namespace

const IntersectMethod kStableQuadratic = {
    .name = "stable-quadratic",
    .sentence = "disc = b^2 - ac, q = b + sign(b) sqrt(disc), roots q/a and c/q",
    .intersect = intersect,
    .intersect_one = HWY_NAMESPACE::intersect_one<One>,
    .roots = HWY_NAMESPACE::roots_of<One>,
    .max_ulp = kStableQuadraticMaxUlp,
    .max_point_ulp = kStableQuadraticMaxPointUlp,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
#endif
