// g++ case.cpp -I/usr/include/simbody -lSimTKcommon -o case
#include <SimTKcommon.h>
#include <algorithm>
#include <cstdio>
int main() {
  double fx = {ox} - {cx}, fy = {oy} - {cy}, fz = {oz} - {cz};
  double a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
  double c = fx * fx + fy * fy + fz * fz - {r} * {r};
  SimTK::Vec<2, SimTK::Complex> x;
  SimTK::PolynomialRootFinder::findRoots(SimTK::Vec3(a, b, c), x);
  auto [s0, s1] = std::minmax({x[0].real(), x[1].real()});
  double s = s0 >= 0 ? s0 : s1;
  x[0].imag() == 0 && s >= 0 ? std::printf("%.17g\n", s) : std::puts("miss");
}
