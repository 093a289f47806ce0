// Sums and products of two numbers, as a rounded result and its rounding error. Internal to fast/.
// Compiled once for each of Highway's targets (fast/internal/lanes.h).

#if defined(RAYCHECK_FAST_INTERNAL_ERROR_FREE_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_ERROR_FREE_H_
#undef RAYCHECK_FAST_INTERNAL_ERROR_FREE_H_
#else
#define RAYCHECK_FAST_INTERNAL_ERROR_FREE_H_
#endif

#include <cmath>

#include "fast/internal/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

/// x + error, unevaluated; |error| <= ulp(x)/2.
template <class N>
struct Rounded {
  N x;
  N error;
};

/// a + b exactly, unless it overflows (Knuth, The Art of Computer Programming 2, 4.2.2).
template <class N>
HWY_INLINE Rounded<N> two_sum(N a, N b) {
  const N sum = a + b;
  const N b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a - b exactly, like two_sum.
template <class N>
HWY_INLINE Rounded<N> two_difference(N a, N b) {
  const N difference = a - b;
  const N b_part = a - difference;
  return {difference, (a - (difference + b_part)) + (b_part - b)};
}

/// two_sum for |a| >= |b| or a = 0 (Dekker, A floating-point technique for extending the available
/// precision, 1971).
template <class N>
HWY_INLINE Rounded<N> fast_two_sum(N a, N b) {
  const N sum = a + b;
  return {sum, b - (sum - a)};
}

/// x rounded to a multiple of 2^-53 scale; off by at most u(|x| + scale).
/// Domain: scale is a power of 2, |x| <= 2^16 scale.
template <class N>
HWY_INLINE N coarse(const N& x, const N& scale) {
  return (x + scale) - scale;
}

#if HWY_NATIVE_FMA

template <class N>
HWY_INLINE N product_error(N a, N b, N product) {
  return mul_sub(a, b, product);
}
template <class N>
HWY_INLINE N square_error(N a, N square) {
  return mul_sub(a, a, square);
}
/// a b - high, rounded once; high is the coarse part of a b.
template <class N>
HWY_INLINE N product_rest(N a, N b, N high) {
  return mul_sub(a, b, high);
}

#else

// Without an FMA instruction, a call of std::fma costs more than the 17 operations of Dekker's
// product, which finds the same errors to the bit unless an intermediate result over- or
// underflows.

/// a b - c, rounded once.
inline HWY_NOINLINE double fused_minus(double a, double b, double c) { return std::fma(a, b, -c); }
inline HWY_NOINLINE Lanes fused_minus(Lanes a, Lanes b, Lanes c) {
  double x[kLaneCount], y[kLaneCount], z[kLaneCount];
  store(a, x);
  store(b, y);
  store(c, z);
  for (std::size_t k = 0; k < kLaneCount; ++k) x[k] = std::fma(x[k], y[k], -z[k]);
  return load(x);
}

/// The error of a product that is at least this large, and all parts of the error, are in the range
/// of doubles.
inline constexpr double kLeastProduct = 0x1p-960;

/// a as the sum of two numbers of at most 26 bits (Veltkamp; in Dekker 1971); NaN if |a| > 2^996.
template <class N>
HWY_INLINE Rounded<N> split(N a) {
  const N scaled = N(0x1p27 + 1) * a;
  const N high = scaled - (scaled - a);
  return {high, a - high};
}

/// Dekker's error of a product, if it is exact; otherwise the error by fused_minus(). Dekker's
/// error is not finite if an intermediate result overflows.
template <class N>
HWY_INLINE N trusted(N error, N a, N b, N product) {
  const auto is_exact = (error - error == N(0)) &
                        ((absolute(product) > N(kLeastProduct)) | (a == N(0)) | (b == N(0)));
  const auto is_nan = !(product == product);  // this lane's error does not matter
  return !all(is_exact | is_nan) ? fused_minus(a, b, product) : error;
}

template <class N>
HWY_INLINE N product_error(N a, N b, N product) {
  const Rounded<N> x = split(a);
  const Rounded<N> y = split(b);
  return trusted(((x.x * y.x - product) + x.x * y.error + x.error * y.x) + x.error * y.error, a, b,
                 product);
}

template <class N>
HWY_INLINE N square_error(N a, N square) {
  const Rounded<N> x = split(a);
  return trusted(((x.x * x.x - square) + N(2) * (x.x * x.error)) + x.error * x.error, a, a, square);
}

template <class N>
HWY_INLINE N product_rest(N a, N b, N high) {
  const N product = a * b;
  return (product - high) + product_error(a, b, product);
}

#endif

/// a b and its error, rounded once: exact if |a b| >= 2^-969, otherwise off by at most 2^-1075.
/// Domain: no overflow.
template <class N>
HWY_INLINE Rounded<N> two_product(N a, N b) {
  const N product = a * b;
  return {product, product_error(a, b, product)};
}

/// a^2 and its error, like two_product.
template <class N>
HWY_INLINE Rounded<N> two_square(N a) {
  const N square = a * a;
  return {square, square_error(a, square)};
}

/// x y - z w, off by a few roundings of the result at most (Kahan; analysed by Jeannerod, Louvet
/// and Muller, Further analysis of Kahan's algorithm for the accurate computation of 2x2
/// determinants, 2013; here with the errors of both products).
template <class N>
HWY_INLINE N difference_of_products(N x, N y, N z, N w) {
  const Rounded<N> first = two_product(x, y);
  const Rounded<N> second = two_product(z, w);
  return (first.x - second.x) + (first.error - second.error);
}

// Numbers of about 106 bits as unevaluated sums. Source of the algorithms and their names: Joldes,
// Muller and Popescu, Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic, 2017. Errors: kDoubleDoubleError in fast/internal/double_double.h.

template <class N>
HWY_INLINE Rounded<N> operator-(const Rounded<N>& x) {
  return {-x.x, -x.error};
}

template <class N>
HWY_INLINE Rounded<N> operator+(const Rounded<N>& x, const Rounded<N>& y) {  // AccurateDWPlusDW
  const Rounded<N> high = two_sum(x.x, y.x);
  const Rounded<N> low = two_sum(x.error, y.error);
  const Rounded<N> middle = fast_two_sum(high.x, high.error + low.x);
  return fast_two_sum(middle.x, low.error + middle.error);
}
template <class N>
HWY_INLINE Rounded<N> operator-(const Rounded<N>& x, const Rounded<N>& y) {
  return x + -y;
}

template <class N>
HWY_INLINE Rounded<N> operator*(const Rounded<N>& x, const Rounded<N>& y) {  // DWTimesDW1
  const Rounded<N> high = two_product(x.x, y.x);
  return fast_two_sum(high.x, high.error + (x.x * y.error + x.error * y.x));
}

template <class N>
HWY_INLINE Rounded<N> operator/(const Rounded<N>& x, const Rounded<N>& y) {  // DWDivDW2
  const N guess = x.x / y.x;
  const Rounded<N> product = two_product(y.x, guess);  // DWTimesFP1
  const Rounded<N> sum = fast_two_sum(product.x, y.error * guess);
  const Rounded<N> times = fast_two_sum(sum.x, sum.error + product.error);
  const N rest = (x.x - times.x) + (x.error - times.error);
  return fast_two_sum(guess, rest / y.x);
}

/// Domain: x > 0.
template <class N>
HWY_INLINE Rounded<N> pair_root(const Rounded<N>& x) {  // SQRTDWtoDW
  const N guess = square_root(x.x);
  const Rounded<N> square = two_square(guess);
  const N rest = (x.x - square.x) - square.error + x.error;
  return fast_two_sum(guess, rest / (N(2) * guess));
}

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_ERROR_FREE_H_
