#pragma once

#include <string_view>

#include "properties/quantity.h"

namespace raycheck::properties {

/// The half of a candidate that can be judged on its own: the rays that it makes, or its answers
/// about given rays.
enum class Stage { kRays, kIntersection };
constexpr std::string_view name(Stage stage) {
  return stage == Stage::kRays ? "rays" : "intersections";
}

/// The quantity that measures a stage's accuracy: the direction, or the parameter.
constexpr Quantity main_quantity(Stage stage) {
  return stage == Stage::kRays ? Quantity::kDirection : Quantity::kParameter;
}

}  // namespace raycheck::properties
