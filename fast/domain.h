#pragma once

namespace raycheck::fast {

/// Lengths whose squares, and the products of two such squares, stay in the double range.
inline constexpr double kSmallestLength = 0x1p-200;
inline constexpr double kLargestLength = 0x1p200;

/// The range of nonzero lengths for which a method's promises hold.
struct Domain {
  double smallest_length = kSmallestLength;
  double largest_length = kLargestLength;
  bool operator==(const Domain&) const = default;
};

/// The products of four such lengths stay in the range of normal floats, with all 24 bits.
inline constexpr Domain kSingleDomain = {0x1p-25, 0x1p25};

/// The quotients of such lengths are normal doubles, so that a method whose intermediate values
/// never over- or underflow can answer with full precision.
inline constexpr Domain kWideDomain = {0x1p-500, 0x1p500};

}  // namespace raycheck::fast
