#pragma once

#include <cmath>
#include <utility>

namespace raycheck::scene {

// Functions of a single number, with the names of those in scene/lanes.h, so that one template of a
// formula works for both.

template <class N>
using MaskOf = decltype(std::declval<N>() < std::declval<N>());

/// Specialise this for number types whose square root is neither in std:: nor in their namespace.
template <class N>
N square_root(const N& x) {
  using std::sqrt;
  return sqrt(x);
}

inline double absolute(double x) { return std::abs(x); }
inline double smaller(double x, double y) { return x < y ? x : y; }
inline double larger(double x, double y) { return x > y ? x : y; }
inline double rounded_up(double x) { return std::ceil(x); }
inline double rounded_down(double x) { return std::floor(x); }

/// `yes` if the condition holds, else `no`.
template <class N>
N select(bool condition, const N& yes, const N& no) {
  return condition ? yes : no;
}

}  // namespace raycheck::scene
