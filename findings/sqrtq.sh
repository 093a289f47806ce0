#!/usr/bin/env bash
# libquadmath's square root misrounds; the C library's function for the same type does not.
#
# Guess: sqrtq() of a __float128 is rounded correctly, as IEEE 754 requires of square roots; so is
# gfortran's sqrt of a real(16).
#
# Happens: a quarter of the roots are off by an ulp (exact squares are right), in gfortran's too;
# glibc's sqrtf128() is always right.
#
# With: libquadmath and gfortran 12.2, glibc 2.36, MPFR 4.2.0, Debian 12
#
# Quadruple precision is often what the doubles' answers are compared with: tie-breaking tests of a
# root there have no correctly rounded root to rely on.
source "$(dirname "$0")/common.sh"
needs g++ gfortran
debian_packages libquadmath0=12.2.0-14* libmpfr-dev=4.2.0-1 libc6=2.36-9+deb12*

cat >root.f90 <<'F90'
subroutine fortran_sqrt(x, root) bind(c)
  real(16), intent(in) :: x
  real(16), intent(out) :: root
  root = sqrt(x)
end subroutine
F90
cat >roots.cpp <<'CPP'
#include <cstdio>
#include <mpfr.h>
#include <quadmath.h>
#include <random>

extern "C" __float128 sqrtf128(__float128);
extern "C" void fortran_sqrt(const __float128*, __float128*);

int main() {
  std::mt19937_64 bits(1);
  mpfr_t exact;
  mpfr_init2(exact, 113);
  constexpr int kCases = 200000;
  int by_quadmath = 0, by_fortran = 0, by_glibc = 0, of_squares = 0;
  for (int i = 0; i < kCases; ++i) {
    const __float128 high = bits() >> 1, low = bits() >> 14;
    const __float128 x = (1 + high * 0x1p-63Q + low * 0x1p-113Q) * (1 + i % 2);
    mpfr_set_float128(exact, x, MPFR_RNDN);
    mpfr_sqrt(exact, exact, MPFR_RNDN);
    const __float128 root = mpfr_get_float128(exact, MPFR_RNDN);
    __float128 fortran;
    fortran_sqrt(&x, &fortran);
    by_quadmath += sqrtq(x) != root;
    by_fortran += fortran != root;
    by_glibc += sqrtf128(x) != root;
    const __float128 integer = bits() >> 32;
    of_squares += sqrtq(integer * integer) != integer;
  }
  std::printf("sqrtq: %d of %d wrong; of exact squares %d\n", by_quadmath, kCases, of_squares);
  std::printf("gfortran's sqrt: %d of %d wrong\n", by_fortran, kCases);
  std::printf("sqrtf128: %d of %d wrong\n", by_glibc, kCases);
}
CPP
gfortran -O2 -c root.f90
g++ -O2 -DMPFR_WANT_FLOAT128 roots.cpp root.o -o roots -lmpfr -lgmp -lquadmath
./roots | tee seen
as_stated <<'SEEN'
sqrtq: 50176 of 200000 wrong; of exact squares 0
gfortran's sqrt: 50176 of 200000 wrong
sqrtf128: 0 of 200000 wrong
SEEN
