#pragma once

#include <cfenv>
#include <string>

namespace raycheck::scene {

/// While it lives, this thread's doubles round to nearest and keep subnormals.
class PlainArithmetic {
 public:
  PlainArithmetic() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~PlainArithmetic() { std::fesetenv(&before_); }
  PlainArithmetic(const PlainArithmetic&) = delete;
  PlainArithmetic& operator=(const PlainArithmetic&) = delete;

 private:
  std::fenv_t before_{};
};

/// How this thread's arithmetic differs from what every bound here assumes: doubles that round to
/// nearest and keep subnormals, with correctly rounded square roots and fused operations. Empty if
/// it does not differ.
std::string arithmetic_defect();

}  // namespace raycheck::scene
