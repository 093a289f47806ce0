#pragma once

#include <array>
#include <string_view>

namespace raycheck::properties {

/// The values that a candidate returns for a hit: s and Q; s; Q; the distance of Q along the ray;
/// the square of that distance; or nothing.
enum class Returns { kHit, kParameter, kPoint, kDistance, kSquaredDistance, kClass };
inline constexpr std::array<std::string_view, 6> kReturnsNames = {
    "hit", "parameter", "point", "distance", "squared-distance", "class"};
constexpr bool gives_point(Returns returns) {
  return returns == Returns::kHit || returns == Returns::kPoint;
}
constexpr bool gives_parameter(Returns returns) {
  return returns != Returns::kPoint && returns != Returns::kClass;
}

}  // namespace raycheck::properties
