#pragma once

#include <cfenv>
#include <string>

namespace raycheck::scene {

/// While it lives this thread's doubles are those of a program without flags: they round to nearest
/// and keep subnormals.
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

/// What keeps this thread's doubles from being those that every bound here takes for granted: they
/// round to nearest, keep subnormals, and have correctly rounded square roots and fused operations.
/// Empty where nothing does.
std::string arithmetic_defect();

}  // namespace raycheck::scene
