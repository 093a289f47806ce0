#ifndef RAYCHECK_FAST_DOMAIN_H_
#define RAYCHECK_FAST_DOMAIN_H_

namespace raycheck::fast {

/// Lengths whose squares, and the products of two such squares, stay in the double range.
inline constexpr double kSmallestLength = 0x1p-200;
inline constexpr double kLargestLength = 0x1p200;

/// The nonzero lengths beyond which a method promises nothing.
struct Domain {
  double smallest_length = kSmallestLength;
  double largest_length = kLargestLength;
  bool operator==(const Domain&) const = default;
};

}  // namespace raycheck::fast

#endif  // RAYCHECK_FAST_DOMAIN_H_
