#pragma once

#include "scene/numbers.h"

namespace raycheck::scene {

// The distance of a real from the double that it was rounded to is at most half an ulp or half the
// least double (sums never need the latter). Beyond the largest double it has no limit.
inline constexpr double kBoundsWiden = 0x1p-52;
inline constexpr double kBoundsTiny = 0x1p-960;
inline constexpr int kBoundsMaxUlp = 3;

#include "scene/plan/bounds_formula.h"

using Bounds = BoundsOf<double>;

}  // namespace raycheck::scene
