#include "scene/plan/plan_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/plan/plan_kernel.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "scene/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::scene {
namespace HWY_NAMESPACE {

#include "scene/plan/bounds_formula.h"
#include "scene/plan/sphere_formula.h"

/// What is planned of kLanes spheres, lane by lane.
template <class N, std::size_t kLanes>
struct Stored {
  alignas(64) double low[6][kLanes], high[6][kLanes], nearest[kLanes], sides[4][kLanes];
  unsigned origin_outside, all_in_front, behind, none;

  HWY_INLINE explicit Stored(const PlannedOf<N>& planned)
      : origin_outside(bits(planned.origin_outside)),
        all_in_front(bits(planned.all_in_front)),
        behind(bits(planned.behind)),
        none(bits(planned.none)) {
    const auto& [u, v, w, distance_sq, power, radius] = planned.seen;
    int at = 0;
    for (const BoundsOf<N>* x : {&u, &v, &w, &distance_sq, &power, &radius}) {
      store(x->low, low[at]);
      store(x->high, high[at++]);
    }
    store(planned.nearest_distance, nearest);
    store(planned.i_begin, sides[0]);
    store(planned.i_end, sides[1]);
    store(planned.j_begin, sides[2]);
    store(planned.j_end, sides[3]);
  }

  HWY_INLINE SpherePlan plan(const PlanTerms& terms, std::size_t lane) const {
    const auto is = [lane](unsigned mask) { return (mask >> lane & 1) != 0; };
    const auto side = [&](int k) { return static_cast<std::int64_t>(sides[k][lane]); };
    const auto bounds = [&](int k) { return Bounds{low[k][lane], high[k][lane]}; };
    const PlanItems& items = terms.items;
    SpherePlan result;
    result.seen = {bounds(0), bounds(1), bounds(2), bounds(3), bounds(4), bounds(5)};
    result.nearest_distance = nearest[lane];
    result.reaches_behind = !items.behind_test || !is(all_in_front);
    result.origin_inside = !items.far_root || (terms.far_root_may_count && !is(origin_outside));
    if (items.behind && is(behind)) {
      result.left_out = LeftOut::kBehind;
      return result;
    }
    if (!is(none)) result.pixels = {side(0), side(1), side(2), side(3)};
    const bool is_outside = result.pixels.empty();
    if (items.view && is_outside) {
      result.left_out = LeftOut::kOutsideView;
      result.pixels = {};
    } else if (!items.rectangles || is_outside) {
      result.pixels = {0, static_cast<std::int64_t>(terms.width), 0,
                       static_cast<std::int64_t>(terms.height)};
    }
    return result;
  }
};

HWY_FLATTEN void plan_in_lanes(const PlanTerms& terms, std::span<const Sphere> spheres,
                               std::span<SpherePlan> plans) {
  std::size_t at = 0;
  for (; at + kLaneCount <= spheres.size(); at += kLaneCount) {
    Lanes x, y, z, radius;
    static_assert(sizeof(Sphere) == 4 * sizeof(double));
    load_fours(&spheres[at].centre.x, x, y, z, radius);
    const Stored<Lanes, kLaneCount> stored(planned<Lanes>(terms, {x, y, z}, radius));
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      plans[at + lane] = stored.plan(terms, lane);
    }
  }
  for (; at < spheres.size(); ++at) {
    const auto& [centre, radius] = spheres[at];
    plans[at] = Stored<double, 1>(planned<double>(terms, {centre.x, centre.y, centre.z}, radius))
                    .plan(terms, 0);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace raycheck::scene
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::scene {

HWY_EXPORT(plan_in_lanes);

void plan_each(const PlanTerms& terms, std::span<const Sphere> spheres,
               std::span<SpherePlan> plans) {
  HWY_DYNAMIC_DISPATCH(plan_in_lanes)(terms, spheres, plans);
}

}  // namespace raycheck::scene
#endif  // HWY_ONCE
