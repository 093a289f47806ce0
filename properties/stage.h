#pragma once

#include <string_view>

#include "properties/quantity.h"

namespace raycheck::properties {

/// The half of a candidate that can be judged alone: the rays that it makes, or what it says about
/// rays given to it.
enum class Stage { kRays, kIntersection };
constexpr std::string_view name(Stage stage) {
  return stage == Stage::kRays ? "rays" : "intersections";
}

/// The quantity by which a stage's accuracy is told: the direction, or the parameter.
constexpr Quantity main_quantity(Stage stage) {
  return stage == Stage::kRays ? Quantity::kDirection : Quantity::kParameter;
}

}  // namespace raycheck::properties
