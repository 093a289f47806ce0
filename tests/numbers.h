#pragma once

#include <limits>

namespace raycheck {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kLargest = std::numeric_limits<double>::max();
inline constexpr double kSmallestNormal = std::numeric_limits<double>::min();
inline constexpr double kSmallest = std::numeric_limits<double>::denorm_min();  ///< 2^-1074
/// Sums of doubles of any size are exact in this number of bits.
inline constexpr int kBitsOfAnySum = 2600;

}  // namespace raycheck
