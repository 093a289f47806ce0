#include "tests/dull/judged.h"

namespace raycheck::dull {

std::span<const WhyExcused> why_excused() {
  static const std::vector<WhyExcused> kReasons = {};
  return kReasons;
}

}  // namespace raycheck::dull
