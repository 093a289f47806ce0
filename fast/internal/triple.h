// Points and vectors of any number type. Internal to fast/. Compiled once for each of Highway's
// targets (fast/internal/lanes.h).

#if defined(RAYCHECK_FAST_INTERNAL_TRIPLE_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_TRIPLE_H_
#undef RAYCHECK_FAST_INTERNAL_TRIPLE_H_
#else
#define RAYCHECK_FAST_INTERNAL_TRIPLE_H_
#endif

#include "fast/internal/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

template <class N>
struct Triple {
  N x, y, z;
};

template <class N, class Plain>
HWY_INLINE Triple<N> triple(const Plain& value) {
  return {N(value.x), N(value.y), N(value.z)};
}

/// Loads from and stores to one array per coordinate.
HWY_INLINE Triple<Lanes> load(const double* const (&from)[3], std::size_t k) {
  return {load(from[0] + k), load(from[1] + k), load(from[2] + k)};
}
HWY_INLINE void store(const Triple<Lanes>& x, double* const (&to)[3], std::size_t k) {
  store(x.x, to[0] + k);
  store(x.y, to[1] + k);
  store(x.z, to[2] + k);
}

template <class N>
HWY_INLINE Triple<N> operator+(const Triple<N>& a, const Triple<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
HWY_INLINE Triple<N> operator-(const Triple<N>& a, const Triple<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
HWY_INLINE Triple<N> operator*(const N& factor, const Triple<N>& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
template <class N>
HWY_INLINE Triple<N> operator/(const Triple<N>& a, const N& divisor) {
  return {a.x / divisor, a.y / divisor, a.z / divisor};
}

template <class N>
HWY_INLINE N dot(const Triple<N>& a, const Triple<N>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
template <class N>
HWY_INLINE N fused_dot(const Triple<N>& a, const Triple<N>& b) {
  return mul_add(a.x, b.x, mul_add(a.y, b.y, a.z * b.z));
}
template <class N>
HWY_INLINE Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
HWY_INLINE N norm(const Triple<N>& a) {
  return square_root(dot(a, a));
}

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_TRIPLE_H_
