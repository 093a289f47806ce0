#pragma once

#include "scene/numbers.h"

namespace raycheck::scene {

// How far a real may be from the double x it was rounded to: half an ulp, or half the least double
// (sums never need the latter). Beyond the largest double, any distance.
inline constexpr double kBoundsWiden = 0x1p-52;
inline constexpr double kBoundsTiny = 0x1p-960;
inline constexpr int kBoundsMaxUlp = 3;

#include "scene/plan/bounds_formula.h"

using Bounds = BoundsOf<double>;

}  // namespace raycheck::scene
