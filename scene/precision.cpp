#include "scene/precision.h"

#include <cmath>
#include <limits>

namespace raycheck::scene {

// Not inline: if two numbers are rounded next to each other, GCC 12 at -O3 vectorises the code and
// drops the conversion to float and back.
[[gnu::noinline]] double rounded_to(Precision precision, double x) {
  return precision == Precision::kSingle ? static_cast<double>(static_cast<float>(x)) : x;
}

double next_after(Precision precision, double x, double toward) {
  if (precision == Precision::kDouble) return std::nextafter(x, toward);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (toward == x) return x;
  return static_cast<double>(
      std::nextafter(static_cast<float>(x), toward > x ? kInfinity : -kInfinity));
}

}  // namespace raycheck::scene
