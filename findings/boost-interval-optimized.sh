#!/usr/bin/env bash
# Boost.Interval compiled by GCC with optimization: no product or quotient is enclosed.
#
# Guess: boost::numeric::interval<double> encloses the exact result whatever the level of
# optimization; at worst a few results escape where the compiler moves an operation.
#
# Happens: with GCC 12 at -O2 all of 10^5 random quotients miss the exact value, at -O3, the level
# of CMake's Release, all products, too: both bounds are one double. Without optimization, with
# -frounding-math, and with clang 14 all are enclosed.
#
# With: Boost 1.74, GCC 12.2, clang 14, Debian 12 (amd64)
#
# Sums are right, and which operations are not depends on the code around them: the tests of a
# Debug build, or of another program, do not find it.
source "$(dirname "$0")/common.sh"
needs g++-12 clang++-14
debian_packages libboost1.74-dev=1.74.0+ds1-21 libgmp-dev=2:6.2.1+dfsg1-1.1* cpp-12=12.2.0-14*

cat >escapes.cpp <<'CPP'
#include <boost/numeric/interval.hpp>
#include <cstdio>
#include <gmpxx.h>
#include <random>

using Interval = boost::numeric::interval<double>;

static bool encloses(const Interval& result, const mpq_class& exact) {
  return mpq_class(result.lower()) <= exact && exact <= mpq_class(result.upper());
}

int main() {
  std::mt19937_64 bits(1);
  std::uniform_real_distribution<double> uniform(-10, 10);
  int sums = 0, products = 0, quotients = 0, points = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = uniform(bits), y = uniform(bits);
    const mpq_class p(x), q(y);
    sums += !encloses(Interval(x) + Interval(y), p + q);
    products += !encloses(Interval(x) * Interval(y), p * q);
    const Interval quotient = Interval(x) / Interval(y);
    quotients += !encloses(quotient, p / q);
    points += quotient.lower() == quotient.upper();
  }
  std::printf("of 100000 escape %d sums, %d products, %d quotients (%d of them one double)\n", sums,
              products, quotients, points);
}
CPP
for compiler in "g++-12 -O0" "g++-12 -O2" "g++-12 -O3" "g++-12 -O3 -frounding-math" "clang++-14 -O3"; do
  $compiler -w escapes.cpp -o escapes -lgmpxx -lgmp
  echo "$compiler: $(./escapes)"
done | tee seen
as_stated <<'SEEN'
g++-12 -O0: of 100000 escape 0 sums, 0 products, 0 quotients (0 of them one double)
g++-12 -O2: of 100000 escape 0 sums, 0 products, 100000 quotients (100000 of them one double)
g++-12 -O3: of 100000 escape 0 sums, 100000 products, 100000 quotients (100000 of them one double)
g++-12 -O3 -frounding-math: of 100000 escape 0 sums, 0 products, 0 quotients (0 of them one double)
clang++-14 -O3: of 100000 escape 0 sums, 0 products, 0 quotients (0 of them one double)
SEEN
