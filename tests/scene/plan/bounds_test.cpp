// The promises of bounds, checked with exact rationals.

#include "scene/plan/bounds.h"

#include <boost/multiprecision/gmp.hpp>

#include "tests/testing.h"

namespace raycheck::scene {
namespace {

using Rational = boost::multiprecision::mpq_rational;

constexpr int kTries = 20000;

/// Doubles of all magnitudes, also the ends of the range, whole numbers and 0.
class Doubles {
 public:
  double any() {
    const auto kind = engine_() % 8;
    if (kind == 0) return static_cast<double>(static_cast<int>(engine_() % 9) - 4);
    if (kind == 1) return around_one() * (engine_() % 2 == 0 ? kSmallest * 16 : kLargest / 2);
    if (kind <= 3) return around_one();
    for (;;) {
      const double x = std::bit_cast<double>(engine_());
      if (std::isfinite(x)) return x;
    }
  }
  /// Bounds that are a double, a few ulps around a double, or two doubles far apart.
  Bounds bounds() {
    const double x = any();
    const auto kind = engine_() % 3;
    if (kind == 0) return Bounds::exactly(x);
    double y = any();
    if (kind == 1) y = x + std::abs(x) * 0x1p-50;
    if (!std::isfinite(y)) y = x;
    return {std::min(x, y), std::max(x, y)};
  }

 private:
  double around_one() {
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(engine_())), -62);
  }

  std::mt19937_64 engine_{1};
};

void expect_holds(const Bounds& bounds, const Rational& exact) {
  ASSERT_FALSE(std::isnan(bounds.low) || std::isnan(bounds.high));
  ASSERT_LE(bounds.low, bounds.high);
  ASSERT_LT(bounds.low, kInfinity);
  ASSERT_GT(bounds.high, -kInfinity);
  ASSERT_TRUE(bounds.low == -kInfinity || Rational(bounds.low) <= exact);
  ASSERT_TRUE(bounds.high == kInfinity || exact <= Rational(bounds.high));
}

/// Checks the width: no end is more than kBoundsMaxUlp beyond the outermost exact value, unless
/// this value is tiny, or too large to have a double next to it.
void expect_tight(const Bounds& bounds, const Rational& least, const Rational& most) {
  const auto is_ordinary = [](const Rational& x) {
    const Rational size = abs(x);
    return size > Rational(2 * kBoundsTiny) && size < Rational(kLargest / 2);
  };
  const auto gap = [](const Rational& x) {
    const double size = std::abs(x.convert_to<double>());
    return Rational(size - std::nextafter(size, 0));
  };
  if (is_ordinary(least)) {
    EXPECT_LE(least - Rational(bounds.low), kBoundsMaxUlp * gap(least)) << bounds.low;
  }
  if (is_ordinary(most)) {
    EXPECT_LE(Rational(bounds.high) - most, kBoundsMaxUlp * gap(most)) << bounds.high;
  }
}

/// Tests the operation with both ends of the operands and a number between them.
template <class Operation>
void expect_binary(Operation operation, bool divides = false) {
  Doubles doubles;
  int compared = 0;
  for (int k = 0; k < kTries; ++k) {
    const Bounds x = doubles.bounds(), y = doubles.bounds();
    const Bounds result = operation(x, y);
    if (divides && y.contains(0)) {
      ASSERT_EQ(result.low, -kInfinity);
      ASSERT_EQ(result.high, kInfinity);
      continue;
    }
    ++compared;
    const auto middle = [](const Bounds& b) { return (Rational(b.low) + Rational(b.high)) / 3; };
    const Rational xs[] = {Rational(x.low), Rational(x.high),
                           std::clamp<Rational>(middle(x), Rational(x.low), Rational(x.high))};
    const Rational ys[] = {Rational(y.low), Rational(y.high),
                           std::clamp<Rational>(middle(y), Rational(y.low), Rational(y.high))};
    Rational least = operation(xs[0], ys[0]), most = least;
    for (const Rational& a : xs) {
      for (const Rational& b : ys) {
        const Rational exact = operation(a, b);
        ASSERT_NO_FATAL_FAILURE(expect_holds(result, exact)) << x.low << " " << y.low;
        least = std::min(least, exact);
        most = std::max(most, exact);
      }
    }
    expect_tight(result, least, most);
  }
  EXPECT_GT(compared, kTries / 2);
}

TEST(Bounds, HoldEveryResultOfTwo) {
  expect_binary([](const auto& x, const auto& y) { return x + y; });
  expect_binary([](const auto& x, const auto& y) { return x - y; });
  expect_binary([](const auto& x, const auto& y) { return x * y; });
  expect_binary([](const auto& x, const auto& y) { return x / y; }, true);
}

TEST(Bounds, HoldEverySquare) {
  Doubles doubles;
  for (int k = 0; k < kTries; ++k) {
    const Bounds x = doubles.bounds();
    const Bounds result = square(x);
    const Rational low = Rational(x.low) * Rational(x.low);
    const Rational high = Rational(x.high) * Rational(x.high);
    ASSERT_NO_FATAL_FAILURE(expect_holds(result, low));
    ASSERT_NO_FATAL_FAILURE(expect_holds(result, high));
    ASSERT_GE(result.low, 0);
    if (x.contains(0)) {
      ASSERT_EQ(result.low, 0);
    }
    expect_tight(result, x.contains(0) ? Rational(0) : std::min(low, high), std::max(low, high));
  }
}

TEST(Bounds, HoldEverySquareRoot) {
  Doubles doubles;
  for (int k = 0; k < kTries; ++k) {
    const Bounds x = doubles.bounds();
    const Bounds result = sqrt(x);
    ASSERT_GE(result.low, 0);
    ASSERT_LE(result.low, result.high);
    const auto sq = [](double end) { return Rational(end) * Rational(end); };
    ASSERT_LE(sq(result.low), std::max(Rational(0), Rational(x.low)));
    if (x.high < 0) continue;
    ASSERT_GE(sq(result.high), Rational(x.high));
    const double inner =
        std::nextafter(std::nextafter(std::nextafter(std::nextafter(result.high, 0), 0), 0), 0);
    if (x.high > 0) {
      EXPECT_LT(sq(inner), Rational(x.high));
    }
  }
}

TEST(Bounds, HoldEveryPowerOfTwo) {
  Doubles doubles;
  std::mt19937_64 engine(2);
  int exact_ends = 0;
  for (int k = 0; k < kTries; ++k) {
    const Bounds x = doubles.bounds();
    const int exponent = static_cast<int>(engine() % 4400) - 2200;
    const Bounds result = scaled(x, exponent);
    const boost::multiprecision::mpz_int power = boost::multiprecision::mpz_int(1)
                                                 << std::abs(exponent);
    for (const double end : {x.low, x.high}) {
      const Rational exact = exponent < 0 ? Rational(end) / power : Rational(end) * power;
      ASSERT_NO_FATAL_FAILURE(expect_holds(result, exact));
      exact_ends += std::isfinite(result.low) && Rational(result.low) == exact ? 1 : 0;
    }
  }
  EXPECT_GT(exact_ends, kTries / 8);
}

TEST(Bounds, AreInfiniteBeyondTheLargestDouble) {
  EXPECT_EQ(sqrt(Bounds{0, kInfinity}).high, kInfinity);
  const Bounds all = Bounds::everything();
  for (const Bounds& result : {all + all, all - all, all * all, all / Bounds::exactly(2),
                               all * Bounds::exactly(-3), Bounds::exactly(1) / all}) {
    EXPECT_EQ(result.low, -kInfinity);
    EXPECT_EQ(result.high, kInfinity);
  }
}

TEST(Bounds, OfZeroTimesAnythingAreZero) {
  const Bounds zero = Bounds::exactly(0);
  for (const Bounds& x : {Bounds::exactly(3), Bounds::everything(), Bounds{-1, kLargest}}) {
    EXPECT_EQ((zero * x).low, 0);
    EXPECT_EQ((zero * x).high, 0);
  }
  EXPECT_EQ((zero + zero).high, 0);
  EXPECT_EQ((Bounds{0, 1} * Bounds{-2, 0}).high, 0);
}

}  // namespace
}  // namespace raycheck::scene
