#include "tests/properties/laws/pair_discriminant.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/properties/laws/pair_discriminant.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "reference/visibility/lanes.h"
#include "reference/visibility/visibility_formula.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::properties::HWY_NAMESPACE {

namespace filter = raycheck::reference::HWY_NAMESPACE;
namespace hn = hwy::HWY_NAMESPACE;
using reference::Pair;

HWY_INLINE filter::PairLanes all(const Pair& x) {
  return {hn::Set(filter::D(), x.high), hn::Set(filter::D(), x.low)};
}
HWY_INLINE Pair first(const filter::PairLanes& x) {
  return {hn::GetLane(x.high), hn::GetLane(x.low)};
}

PairRoots roots(const reference::FilteredSphereOf<Pair>& sphere, const reference::PairRays& rays) {
  const filter::PairLanes u = all(sphere.u), v = all(sphere.v), w = all(sphere.w);
  const filter::PairLanes alpha =
      mul_add(all({rays.first_column, 0}), all(rays.step), all(rays.first));
  const auto row = filter::row_terms(all(rays.near), all(rays.beta[0]), u, v, w);
  const filter::PairLanes disc = filter::discriminant_by_moment(
      filter::moment_of(alpha, v, w, row), filter::a_of(alpha, row.a), all(sphere.radius_sq));
  const auto is_above_0 = hn::Gt(disc.high, hn::Zero(filter::D()));
  return {first(filter::b_of(alpha, u, row.b)), first(disc), first(root_where(is_above_0, disc))};
}

}  // namespace raycheck::properties::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::properties {

HWY_EXPORT(roots);

PairRoots pair_roots(const reference::FilteredSphereOf<reference::Pair>& sphere,
                     const reference::PairRays& rays) {
  return HWY_DYNAMIC_DISPATCH(roots)(sphere, rays);
}

}  // namespace raycheck::properties
#endif  // HWY_ONCE
