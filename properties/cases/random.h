#pragma once

#include <cmath>
#include <cstdint>

#include "scene/geometry.h"

namespace raycheck::properties {

/// A stream of random numbers that is the same on every machine (the standard's distributions are
/// not), and starts at no cost: SplitMix64 (Steele, Lea and Flood, Fast splittable pseudorandom
/// number generators, 2014). Never draw two numbers in the arguments of one call or in the operands
/// of one operator, because the compiler chooses their order.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    skip(1);
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// Skips this number of draws.
  void skip(std::uint64_t draws) { state_ += draws * 0x9e3779b97f4a7c15; }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + unit() * (high - low); }
  /// Uniform among the integers low..high.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(std::int64_t n) { return integer(1, n) == 1; }
  double sign() { return one_in(2) ? 1 : -1; }
  /// 10^x, x uniform in [low, high).
  double power_of_ten(double low, double high) { return std::pow(10.0, between(low, high)); }
  double small_integer(std::int64_t size) { return static_cast<double>(integer(-size, size)); }
  scene::Vector3 in_cube(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
  /// sign() 10^x, x uniform in [low, high).
  double signed_power_of_ten(double low, double high) {
    const double positive_or_negative = sign();
    return positive_or_negative * power_of_ten(low, high);
  }
  scene::Vector3 direction() {
    for (;;) {
      const scene::Vector3 v = in_cube(1);
      const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
      if (length > 0.1 && length < 1) return {v.x / length, v.y / length, v.z / length};
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace raycheck::properties
