#include "scene/arithmetic.h"

#include <cmath>
#include <limits>

namespace raycheck::scene {

std::string arithmetic_defect() {
  // Volatile, so that the compiler does not compute this in advance.
  const volatile double one = 1, least = std::numeric_limits<double>::min();
  const volatile double half_ulp = 0x1p-53, below_two = 0x1.fffffffffffffp+0;
  if (std::fegetround() != FE_TONEAREST || one + half_ulp != 1 || -one - half_ulp != -1 ||
      one + 3 * half_ulp != 1 + 0x1p-51) {
    return "doubles do not round to nearest";
  }
  if (least / 2 == 0 || (least / 2) * 2 != least) {
    return "subnormal doubles are flushed to zero";
  }
  if (std::sqrt(below_two) != 0x1.6a09e667f3bccp+0) {
    return "square roots are not correctly rounded";
  }
  if (std::fma(one + 0x1p-52, one + 0x1p-52, -one - 0x1p-51) != 0x1p-104) {
    return "fused operations round twice";
  }
  return {};
}

}  // namespace raycheck::scene
