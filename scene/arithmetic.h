#pragma once

#include <cfenv>
#include <string>

namespace raycheck::scene {

/// While an object lives, this thread's doubles round to nearest and keep subnormals.
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

/// What is wrong with this thread's arithmetic; empty if nothing is. All error bounds assume
/// doubles that round to nearest and keep subnormals, and correctly rounded square roots and fused
/// operations.
std::string arithmetic_defect();

}  // namespace raycheck::scene
