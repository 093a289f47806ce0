// scene/lanes.h for the formulas of fast/. Internal to fast/.

#if defined(RAYCHECK_FAST_INTERNAL_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_LANES_H_
#undef RAYCHECK_FAST_INTERNAL_LANES_H_
#else
#define RAYCHECK_FAST_INTERNAL_LANES_H_
#endif

#include "scene/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using scene::HWY_NAMESPACE::absolute;
using scene::HWY_NAMESPACE::all;
using scene::HWY_NAMESPACE::any;
using scene::HWY_NAMESPACE::bits;
using scene::HWY_NAMESPACE::DoubleTag;
using scene::HWY_NAMESPACE::kLaneCount;
using scene::HWY_NAMESPACE::LaneMask;
using scene::HWY_NAMESPACE::Lanes;
using scene::HWY_NAMESPACE::larger;
using scene::HWY_NAMESPACE::load;
using scene::HWY_NAMESPACE::MaskOf;
using scene::HWY_NAMESPACE::select;
using scene::HWY_NAMESPACE::smaller;
using scene::HWY_NAMESPACE::square_root;
using scene::HWY_NAMESPACE::store;

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_LANES_H_
