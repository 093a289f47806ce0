#!/usr/bin/env bash
# CGAL's exact numbers read decimals in three ways.
#
# Guess: 0.1 read from a stream becomes the double 0.1 in a lazy kernel (its numbers start as
# doubles), and 1/10 in CGAL::Exact_rational, the number type for exact input.
#
# Happens: a number of Exact_predicates_exact_constructions_kernel is exactly 1/10, as is
# CGAL::Gmpq; Exact_rational, here Boost's mpq_rational, throws. It reads 1/10 only as a fraction.
#
# With: CGAL 5.5.1, Boost 1.74, Debian 12
#
# Code over any kernel that reads points from a file works for the kernels, and throws for the type
# that they compute with. A scene of doubles must not be read into a kernel as decimals: each
# number is another one.
source "$(dirname "$0")/common.sh"
needs g++
debian_packages libcgal-dev=5.5.1-2 libboost1.74-dev=1.74.0+ds1-21 libgmp-dev=2:6.2.1+dfsg1-1.1*

cat >read.cpp <<'CPP'
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpq.h>
#include <iostream>
#include <sstream>

template <class Number>
void read(const char* name, const char* text) {
  std::cout << name << ": " << text << " is ";
  try {
    Number number(0);
    std::istringstream(text) >> number;
    const bool tenth = number * Number(10) == Number(1), rounded = number == Number(0.1);
    std::cout << (tenth ? "1/10" : rounded ? "the double 0.1" : "something else") << '\n';
  } catch (const std::runtime_error&) {
    std::cout << "thrown at\n";
  }
}

int main() {
  read<CGAL::Exact_predicates_exact_constructions_kernel::FT>("lazy kernel", "0.1");
  read<CGAL::Gmpq>("Gmpq", "0.1");
  read<CGAL::Exact_rational>("Exact_rational", "0.1");
  read<CGAL::Exact_rational>("Exact_rational", "1/10");
}
CPP
g++ -O1 -w read.cpp -o read -lgmp -lmpfr
./read | tee seen
as_stated <<'SEEN'
lazy kernel: 0.1 is 1/10
Gmpq: 0.1 is 1/10
Exact_rational: 0.1 is thrown at
Exact_rational: 1/10 is 1/10
SEEN
