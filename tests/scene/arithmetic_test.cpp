#include "scene/arithmetic.h"

#include <gtest/gtest.h>

#include <cfenv>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace raycheck::scene {
namespace {

TEST(Arithmetic, IsThatOfIeee754) { EXPECT_EQ(arithmetic_defect(), ""); }

TEST(Arithmetic, IsFoundToRoundOtherwise) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::string defect = arithmetic_defect();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(defect, "doubles do not round to nearest") << mode;
  }
}

#if defined(__SSE2__)
TEST(Arithmetic, IsFoundToFlushToZero) {
  constexpr unsigned kFlushResults = 0x8000, kFlushOperands = 0x0040;
  for (const unsigned flush : {kFlushResults, kFlushOperands}) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | flush);
    const std::string defect = arithmetic_defect();
    _mm_setcsr(before);
    EXPECT_EQ(defect, "subnormal doubles are flushed to zero") << flush;
  }
}
#endif

}  // namespace
}  // namespace raycheck::scene
