#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace raycheck::properties {

/// What it takes to be right on a case, as measured at the dials of properties/cases/. A level
/// includes all levels before it.
enum class Level {
  kOrdinary,   ///< Any plain, careful code in doubles.
  kDemanding,  ///< A stable method: far, grazing, nearly tied; no square over- or underflows.
  kExtreme     ///< All that doubles can express.
};
inline constexpr std::array<std::string_view, 3> kLevelNames = {"ordinary", "demanding", "extreme"};
constexpr std::string_view name(Level level) {
  return kLevelNames[static_cast<std::size_t>(level)];
}

}  // namespace raycheck::properties
