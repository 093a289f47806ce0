#!/usr/bin/env bash
# The rounding mode of OpenMP's threads: one program, two compilers, two answers.
#
# Guess: fesetround() before a parallel region holds in it, with both OpenMP libraries (or in
# neither, since the mode belongs to the thread).
#
# Happens: LLVM's libomp sets the caller's mode in all threads at each region. GCC's libgomp does
# not: each of its threads keeps the mode that its creator had at the first region. If a region ran
# before fesetround(), only the caller rounds upward; if not, the others still do after the caller
# is back at rounding to nearest.
#
# With: libgomp (GCC 12.2), libomp 14.0.6, Debian 12
#
# Interval arithmetic that sets the mode once and then runs in parallel encloses nothing with
# libgomp, and ordinary code after it is off by an ulp in 3 of 4 threads.
source "$(dirname "$0")/common.sh"
needs g++ clang++-14
debian_packages libgomp1=12.2.0-14* libomp-14-dev=1:14.0.6* libomp5-14=1:14.0.6*

cat >mode.cpp <<'CPP'
#include <cfenv>
#include <cstdio>

static void region(const char* when) {
  int upward = 0, threads = 0;
#pragma omp parallel num_threads(4) reduction(+ : upward, threads)
  {
    upward += std::fegetround() == FE_UPWARD;
    threads += 1;
  }
  std::printf("  %d of %d threads round upward %s\n", upward, threads, when);
}

int main(int arguments, char**) {
  if (arguments > 1) region("in a region before fesetround(FE_UPWARD)");
  std::fesetround(FE_UPWARD);
  region("after fesetround(FE_UPWARD)");
  std::fesetround(FE_TONEAREST);
  region("after fesetround(FE_TONEAREST)");
}
CPP
g++ -O2 -fopenmp mode.cpp -o libgomp
llvm=root/usr/lib/llvm-14/lib
clang++-14 -O2 -fopenmp=libomp -L"$llvm" mode.cpp -o libomp
export LD_LIBRARY_PATH=$folder/$llvm:$LD_LIBRARY_PATH OMP_DYNAMIC=false
for library in libgomp libomp; do
  echo "$library, the first region before fesetround:"
  "./$library" first
  echo "$library, the first region after fesetround:"
  "./$library"
done | tee seen
as_stated <<'SEEN'
libgomp, the first region before fesetround:
  0 of 4 threads round upward in a region before fesetround(FE_UPWARD)
  1 of 4 threads round upward after fesetround(FE_UPWARD)
  0 of 4 threads round upward after fesetround(FE_TONEAREST)
libgomp, the first region after fesetround:
  4 of 4 threads round upward after fesetround(FE_UPWARD)
  3 of 4 threads round upward after fesetround(FE_TONEAREST)
libomp, the first region before fesetround:
  0 of 4 threads round upward in a region before fesetround(FE_UPWARD)
  4 of 4 threads round upward after fesetround(FE_UPWARD)
  0 of 4 threads round upward after fesetround(FE_TONEAREST)
libomp, the first region after fesetround:
  4 of 4 threads round upward after fesetround(FE_UPWARD)
  0 of 4 threads round upward after fesetround(FE_TONEAREST)
SEEN
