#include "Vector.h"
#include <stdexcept>

Vector Vector::normalized() const {
  double n = length();
  if (n == 0) throw std::runtime_error("cannot normalize the zero vector");
  return (1 / n) * *this;
}
