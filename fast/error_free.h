#ifndef RAYCHECK_FAST_ERROR_FREE_H_
#define RAYCHECK_FAST_ERROR_FREE_H_

// Sums and products of two doubles as a rounded result and its exact error. Internal to fast/.
// Products are split as Dekker does, not by std::fma: without the instruction, which is not asked
// for at build time, a call of std::fma costs more than the 17 operations. Results agree to the
// bit.

namespace raycheck::fast {

/// x + error, unevaluated; |error| <= ulp(x)/2.
struct Rounded {
  double x;
  double error;
};

/// a + b exactly, unless it overflows (Knuth, The Art of Computer Programming 2, 4.2.2).
inline Rounded two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The same where |a| >= |b| or a = 0 (Dekker, A floating-point technique for extending the
/// available precision, 1971).
inline Rounded fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a as two numbers of at most 26 bits (Veltkamp; in Dekker 1971). Domain: |a| < 2^996.
inline Rounded split(double a) {
  constexpr double kSplitter = 0x1p27 + 1;
  const double scaled = kSplitter * a;
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// a b exactly (Dekker 1971). Domain: |a|, |b| < 2^996, no overflow; off by at most 2^-1072 where
/// |a b| < 2^-969, since errors are then below the double range.
inline Rounded two_product(double a, double b) {
  const double product = a * b;
  const Rounded x = split(a);
  const Rounded y = split(b);
  return {product, ((x.x * y.x - product) + x.x * y.error + x.error * y.x) + x.error * y.error};
}

/// a^2 exactly, as two_product.
inline Rounded two_square(double a) {
  const double square = a * a;
  const Rounded x = split(a);
  return {square, ((x.x * x.x - square) + 2 * (x.x * x.error)) + x.error * x.error};
}

/// x y - z w with no more error than a few roundings of the result (Kahan; analysed by Jeannerod,
/// Louvet and Muller, Further analysis of Kahan's algorithm for the accurate computation of 2x2
/// determinants, 2013; here with the errors of both products).
inline double difference_of_products(double x, double y, double z, double w) {
  const Rounded first = two_product(x, y);
  const Rounded second = two_product(z, w);
  return (first.x - second.x) + (first.error - second.error);
}

}  // namespace raycheck::fast

#endif  // RAYCHECK_FAST_ERROR_FREE_H_
