#include "scene/plan/plan_kernel.h"

#include <algorithm>
#include <array>
#include <limits>

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

/// Plans as many of the first spheres as fill a vector. If fewer are left, copies of the first fill
/// the vector.
HWY_FLATTEN std::size_t plan_first(const PlanTerms& terms, std::span<const Sphere> spheres,
                                   PlannedNumbers& to) {
  static_assert(kLaneCount <= PlannedNumbers::kMostLanes && sizeof(Sphere) == 4 * sizeof(double));
  const std::size_t count = std::min(spheres.size(), kLaneCount);
  std::array<Sphere, kLaneCount> some;
  const Sphere* first = spheres.data();
  if (count < kLaneCount) {
    some.fill(spheres.front());
    std::copy_n(first, count, some.begin());
    first = some.data();
  }
  Lanes x, y, z, radius;
  load_fours(&first->centre.x, x, y, z, radius);
  plan_numbers<Lanes>(terms, {x, y, z}, radius, to);
  return count;
}

}  // namespace HWY_NAMESPACE
}  // namespace raycheck::scene
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::scene {

HWY_EXPORT(plan_first);

namespace {

void set_plan(const PlanTerms& terms, const PlannedNumbers& planned, std::size_t lane,
              SpherePlan& result) {
  const auto is = [lane](unsigned mask) { return (mask >> lane & 1) != 0; };
  const auto bounds = [&](int k) { return Bounds{planned.low[k][lane], planned.high[k][lane]}; };
  const auto side = [&](int k) { return static_cast<std::int64_t>(planned.sides[k][lane]); };
  const PlanItems& items = terms.items;
  result.left_out = {};
  result.hidden_by = {};
  result.pixels = {};
  result.seen = {bounds(0), bounds(1), bounds(2), bounds(3), bounds(4), bounds(5)};
  result.reaches_behind = !items.behind_test || !is(planned.in_front);
  result.origin_inside =
      !items.far_root || (terms.far_root_may_count && !is(planned.origin_outside));
  if (items.behind && is(planned.behind)) {
    result.left_out = LeftOut::kBehind;
    return;
  }
  if (!is(planned.none)) result.pixels = {side(0), side(1), side(2), side(3)};
  const bool is_outside = result.pixels.empty();
  if (items.view && is_outside) {
    result.left_out = LeftOut::kOutsideView;
    result.pixels = {};
  } else if (!items.rectangles || is_outside) {
    result.pixels = {0, static_cast<std::int64_t>(terms.width), 0,
                     static_cast<std::int64_t>(terms.height)};
  }
}

}  // namespace

void plan_each(const PlanTerms& terms, std::span<const Sphere> spheres, std::span<SpherePlan> plans,
               std::span<double> nearest_distance) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  PlannedNumbers planned;
  for (std::size_t at = 0; at < spheres.size();) {
    const std::size_t count = HWY_DYNAMIC_DISPATCH(plan_first)(terms, spheres.subspan(at), planned);
    for (std::size_t lane = 0; lane < count; ++lane, ++at) {
      set_plan(terms, planned, lane, plans[at]);
      nearest_distance[at] = plans[at].left_out ? kInfinity : planned.nearest_distance[lane];
    }
  }
}

}  // namespace raycheck::scene
#endif  // HWY_ONCE
