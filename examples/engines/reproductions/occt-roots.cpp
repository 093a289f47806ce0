// g++ case.cpp -I/usr/include/opencascade -lTKMath -lTKernel -o case
#include <math_DirectPolynomialRoots.hxx>
#include <algorithm>
#include <cstdio>
int main() {
  double fx = {ox} - {cx}, fy = {oy} - {cy}, fz = {oz} - {cz};
  double a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
  double c = fx * fx + fy * fy + fz * fz - {r} * {r};
  math_DirectPolynomialRoots x(a, b, c);
  if (!x.IsDone() || x.NbSolutions() == 0) return std::puts("miss"), 0;
  auto [s0, s1] = std::minmax({x.Value(1), x.Value(x.NbSolutions())});
  double s = s0 >= 0 ? s0 : s1;
  s >= 0 ? std::printf("%.17g\n", s) : std::puts("miss");
}
