#!/usr/bin/env bash
# QD's double-doubles: the square root of a square is not its side, and text loses digits.
#
# Guess: dd_real has 106 bits: the square root of an exact square is exact, 40 digits written and
# read again give the same number, and a sum's relative error is a few units of 2^-104.
#
# Happens: for 8% of the integers n from 1e9 to 2e9, sqrt(n * n) is not n. Most numbers come back
# from 40 digits as another one. A sum that cancels is off by more than 1000 units of 2^-104.
#
# With: QD 2.3.23, GCC 12.2, Debian 12 (amd64)
#
# The exact tangent of a ray, where a discriminant is 0 or a square, is not exact in double-doubles
# either. QD can be built with the exact addition (--enable-ieee-add); Debian's is not.
source "$(dirname "$0")/common.sh"
needs g++
debian_packages libqd-dev=2.3.23+dfsg.1-1 libmpfr-dev=4.2.0-1

cat >digits.cpp <<'CPP'
#include <cmath>
#include <cstdio>
#include <mpfr.h>
#include <qd/dd_real.h>
#include <random>

static std::mt19937_64 bits(1);

// From 1 to 2, with about 106 random bits.
static dd_real random_number() {
  const double high = 1 + std::ldexp(bits() >> 11, -53);
  return dd_real(high) + dd_real(std::ldexp(std::ldexp(bits() >> 11, -53) - 0.5, -53));
}

static void set(mpfr_t exact, const dd_real& number) {
  mpfr_set_d(exact, number.x[0], MPFR_RNDN);
  mpfr_add_d(exact, exact, number.x[1], MPFR_RNDN);
}

int main() {
  constexpr int kCases = 50000;
  int squares = 0, texts = 0, sums = 0;
  mpfr_t a, b, sum;
  mpfr_inits2(400, a, b, sum, mpfr_ptr());
  for (int i = 0; i < kCases; ++i) {
    const dd_real n(1e9 + static_cast<double>(bits() % 1000000000));
    squares += sqrt(n * n) != n;
    const dd_real x = random_number(), y = -x * (1 - 1e-7 * random_number());
    texts += dd_real(x.to_string(40).c_str()) != x;
    set(a, x);
    set(b, y);
    mpfr_add(sum, a, b, MPFR_RNDN);
    set(a, x + y);
    mpfr_sub(a, a, sum, MPFR_RNDN);
    mpfr_div(a, a, sum, MPFR_RNDN);
    sums += std::fabs(std::ldexp(mpfr_get_d(a, MPFR_RNDN), 104)) > 1000;
  }
  std::printf("sqrt(n * n) is not n: %d%%\n", (100 * squares + kCases / 2) / kCases);
  std::printf("40 digits give another number: %d%%\n", (100 * texts + kCases / 2) / kCases);
  std::printf("sums off by more than 1000 units: %s\n", sums ? "some" : "none");
}
CPP
g++ -O2 digits.cpp -o digits -lqd -lmpfr -lgmp
./digits | tee seen
as_stated <<'SEEN'
sqrt(n * n) is not n: 8%
40 digits give another number: 85%
sums off by more than 1000 units: some
SEEN
