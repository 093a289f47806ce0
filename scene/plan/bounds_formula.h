// Interval arithmetic for the types of numbers in scene/numbers.h and scene/lanes.h. Do not include
// this file directly: bounds.h includes it in raycheck::scene, and plan_kernel.cpp in the namespace
// of each of Highway's targets, to compile its functions for that target.

/// All reals from low to high; an end is infinite if no bound is known.
/// Error:  the result of an operation encloses its values for all reals in the operands. Unless
///         these values are tiny or beyond the largest double, each end is at most kBoundsMaxUlp
///         ulp too far out.
/// Domain: doubles that round to nearest; low <= high, neither is NaN, low < inf, high > -inf.
template <class N>
struct BoundsOf {
  N low{0.0}, high{0.0};

  static BoundsOf exactly(N value) { return {value, value}; }
  static BoundsOf everything() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {N(-kInfinity), N(kInfinity)};
  }
  MaskOf<N> contains(N value) const { return (low <= value) & (value <= high); }
  bool operator==(const BoundsOf&) const = default;
};

/// A number below every real that rounds to x. Domain: x is a normal double.
template <class N>
N lowered(const N& x, const N& magnitude, double widen = kBoundsWiden) {
  return x - magnitude * N(widen);
}

/// lowered() subtracts a share of this magnitude from x. Unless x is exact, it is large enough for
/// the share not to vanish.
template <class N>
N unvanishing(N x, MaskOf<N> is_exact) {
  constexpr double kLeastNormal = std::numeric_limits<double>::min();
  return larger(absolute(x), select(is_exact, N(0.0), N(kLeastNormal)));
}
template <class N>
N bound_below(N x, MaskOf<N> is_exact) {
  const N most = smaller(x, N(std::numeric_limits<double>::max()));
  return lowered(most, unvanishing(most, is_exact));
}
template <class N>
N bound_above(N x, MaskOf<N> is_exact) {
  const N least = larger(x, N(-std::numeric_limits<double>::max()));
  return lowered(least, unvanishing(least, is_exact), -kBoundsWiden);
}
/// Bounds on rounded sums and square roots, which are exact if they are subnormal.
template <class N>
BoundsOf<N> widened(N low, N high) {
  const N most(std::numeric_limits<double>::max());
  low = smaller(low, most);
  high = larger(high, -most);
  return {lowered(low, absolute(low)), lowered(high, absolute(high), -kBoundsWiden)};
}

template <class N>
BoundsOf<N> operator-(const BoundsOf<N>& x) {
  return {-x.high, -x.low};
}
template <class N>
BoundsOf<N> operator+(const BoundsOf<N>& x, const BoundsOf<N>& y) {
  return widened(x.low + y.low, x.high + y.high);
}
template <class N>
BoundsOf<N> operator-(const BoundsOf<N>& x, const BoundsOf<N>& y) {
  return x + -y;
}

/// A product of reals: 0 times anything, even infinity, is 0. Lanes whose product underflows to 0
/// are added to `vanished`. (Lambdas would not be compiled for a target of Highway's.)
template <class N>
N product(N x, N y, MaskOf<N>& vanished) {
  const N zero(0.0);
  const MaskOf<N> is_zero = (x == zero) | (y == zero);
  const N result = select(is_zero, zero, x * y);
  vanished = vanished | ((result == zero) ^ is_zero);
  return result;
}

template <class N>
BoundsOf<N> operator*(const BoundsOf<N>& x, const BoundsOf<N>& y) {
  const N zero(0.0);
  MaskOf<N> vanished = zero < zero;
  const N a = product(x.low, y.low, vanished), b = product(x.low, y.high, vanished);
  const N c = product(x.high, y.low, vanished), d = product(x.high, y.high, vanished);
  const N low = smaller(smaller(a, b), smaller(c, d)), high = larger(larger(a, b), larger(c, d));
  return {bound_below(low, (low == zero) & !vanished),
          bound_above(high, (high == zero) & !vanished)};
}

/// Equal to x y for y >= 0, but faster.
template <class N>
BoundsOf<N> times_positive(const BoundsOf<N>& x, const BoundsOf<N>& y) {
  const N zero(0.0);
  const N by_low = select(x.low < zero, y.high, y.low),
          by_high = select(x.high < zero, y.low, y.high);
  const MaskOf<N> low_is_zero = (x.low == zero) | (by_low == zero);
  const MaskOf<N> high_is_zero = (x.high == zero) | (by_high == zero);
  return {bound_below(select(low_is_zero, zero, x.low * by_low), low_is_zero),
          bound_above(select(high_is_zero, zero, x.high * by_high), high_is_zero)};
}

/// Equal to x y for bounds y that all lanes share, but faster if their sign is known.
template <class N, class Shared>
BoundsOf<N> times_shared(const BoundsOf<N>& x, const Shared& y) {
  const BoundsOf<N> each = {N(y.low), N(y.high)};
  if (y.low >= 0) return times_positive(x, each);
  if (y.high <= 0) return -times_positive(x, -each);
  return x * each;
}

template <class N>
BoundsOf<N> square(const BoundsOf<N>& x) {
  const N zero(0.0), low = absolute(x.low), high = absolute(x.high), most = larger(low, high);
  const N least = select(x.contains(zero), zero, smaller(low, high));
  return {larger(zero, bound_below(least * least, least == zero)),
          bound_above(most * most, most == zero)};
}

/// The quotient; all reals if the divisor may be 0.
template <class N>
BoundsOf<N> operator/(const BoundsOf<N>& x, const BoundsOf<N>& y) {
  const N zero(0.0);
  const MaskOf<N> negates = y.high < zero, nowhere = zero < zero;
  const N low = select(negates, -x.high, x.low), high = select(negates, -x.low, x.high);
  const N least = select(negates, -y.high, y.low), most = select(negates, -y.low, y.high);
  // A computed 0 may be an underflow of a positive or a negative quotient.
  const N below = bound_below(low / select(low < zero, least, most), nowhere);
  const N above = bound_above(high / select(high < zero, most, least), nowhere);
  const BoundsOf<N> everything = BoundsOf<N>::everything();
  const MaskOf<N> unknown = y.contains(zero);
  return {select(unknown, everything.low, below), select(unknown, everything.high, above)};
}

/// Whether `scaled`, a product of x and a power of two, is exact.
template <class N>
MaskOf<N> is_exactly_scaled(N x, N scaled) {
  const N size = absolute(scaled);
  return (x == N(0.0)) |
         ((size > N(kBoundsTiny)) & (size <= N(std::numeric_limits<double>::max())));
}

template <class N>
BoundsOf<N> scaled(const BoundsOf<N>& x, int exponent) {
  if (exponent == 0) return x;
  // In steps, since 2^exponent may be out of range. A number that is tiny after one step vanishes
  // in the next.
  const N third(std::ldexp(1.0, exponent / 3)), rest(std::ldexp(1.0, exponent - exponent / 3 * 2));
  const N low = x.low * rest * third * third, high = x.high * rest * third * third;
  const MaskOf<N> never = low < low;
  return {select(is_exactly_scaled(x.low, low), low, bound_below(low, never)),
          select(is_exactly_scaled(x.high, high), high, bound_above(high, never))};
}

/// The square root of the part of x that is not negative.
template <class N>
BoundsOf<N> sqrt(const BoundsOf<N>& x) {
  const N zero(0.0);
  const BoundsOf<N> root =
      widened(square_root(larger(zero, x.low)), square_root(larger(zero, x.high)));
  return {larger(zero, root.low), root.high};
}
