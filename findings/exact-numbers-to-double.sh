#!/usr/bin/env bash
# Exact integers and fractions lose up to an ulp on their way to a double, in some types only.
#
# Guess: converting an exact integer or fraction to double gives the nearest double, as for Python's
# int and Fraction; within one library all types do the same.
#
# Happens: gmpy2's float(mpz) and float(mpq) truncate: half of them differ from float(int) and
# float(Fraction) of the same value. In Boost.Multiprecision mpz_int truncates; cpp_int,
# cpp_rational and mpq_rational round to nearest, but in Boost 1.74 cpp_int does not always.
#
# With: gmpy2 2.1.2, GMP 6.2.1, Boost 1.74 and 1.81, Debian 12
#
# The cause is GMP's mpz_get_d() and mpq_get_d(), whose manual says that they truncate. An expected
# value made by such a conversion is wrong half of the time.
source "$(dirname "$0")/common.sh"
needs g++ python3
debian_packages libboost1.74-dev=1.74.0+ds1-21 libgmp-dev=2:6.2.1+dfsg1-1.1* libmpfr-dev=4.2.0-1 \
  python3-gmpy2=2.1.2-2+b1
mkdir newer
(
  cd newer
  apt-get -qq download libboost1.81-dev=1.81.0-5+deb12u1 >/dev/null 2>&1
  dpkg-deb -x libboost1.81-dev_*.deb .
) || exit 77

cat >convert.py <<'PY'
import random
from fractions import Fraction

import gmpy2

random.seed(1)
integers = fractions = 0
for _ in range(100000):
    p, q = random.getrandbits(128) | 1, random.getrandbits(128) | 1
    integers += float(gmpy2.mpz(p)) != float(p)
    fractions += float(gmpy2.mpq(p, q)) != float(Fraction(p, q))
print(f"gmpy2, of 100000: mpz {integers // 1000}%, mpq {fractions // 1000}% are not the nearest")
PY
cat >convert.cpp <<'CPP'
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <boost/version.hpp>
#include <cstdio>
#include <mpfr.h>
#include <random>

using namespace boost::multiprecision;

int main() {
  std::mt19937_64 bits(5);
  mpfr_t nearest;
  mpfr_init2(nearest, 53);
  constexpr int kCases = 100000;
  int cpp_integer = 0, gmp_integer = 0, cpp_fraction = 0, gmp_fraction = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::uint64_t high = bits() | 1, low = bits() | 1;
    const mpz_int p = (mpz_int(high) << 64) + low;
    mpfr_set_z(nearest, p.backend().data(), MPFR_RNDN);
    double exact = mpfr_get_d(nearest, MPFR_RNDN);
    gmp_integer += p.convert_to<double>() != exact;
    cpp_integer += ((cpp_int(high) << 64) + low).convert_to<double>() != exact;
    const mpq_rational fraction{mpz_int(high), mpz_int(low)};
    mpfr_set_q(nearest, fraction.backend().data(), MPFR_RNDN);
    exact = mpfr_get_d(nearest, MPFR_RNDN);
    gmp_fraction += fraction.convert_to<double>() != exact;
    cpp_fraction += cpp_rational(cpp_int(high), cpp_int(low)).convert_to<double>() != exact;
  }
  std::printf("Boost %s, of %d: mpz_int %d%%, mpq_rational %d, cpp_rational %d, cpp_int %s",
              BOOST_LIB_VERSION, kCases, gmp_integer * 100 / kCases, gmp_fraction, cpp_fraction,
              cpp_integer == 0 ? "0" : cpp_integer < 100 ? "1 to 99" : "more");
  std::puts(" are not nearest");
}
CPP
g++ -O1 -w convert.cpp -o older -lmpfr -lgmp
g++ -O1 -w -Inewer/usr/include convert.cpp -o newest -lmpfr -lgmp
{ python3 convert.py && ./older && ./newest; } | tee seen
as_stated <<'SEEN'
gmpy2, of 100000: mpz 50%, mpq 49% are not the nearest
Boost 1_74, of 100000: mpz_int 50%, mpq_rational 0, cpp_rational 0, cpp_int 1 to 99 are not nearest
Boost 1_81, of 100000: mpz_int 50%, mpq_rational 0, cpp_rational 0, cpp_int 0 are not nearest
SEEN
