// v=$(ls /usr/include | grep ^vtk-) && g++ case.cpp -I/usr/include/$v -lvtkCommonMath-${v#vtk-} -lvtkCommonCore-${v#vtk-} -lvtksys-${v#vtk-} -o case
#include <vtkPolynomialSolversUnivariate.h>
#include <algorithm>
#include <cstdio>
int main() {
  double fx = {ox} - {cx}, fy = {oy} - {cy}, fz = {oz} - {cz};
  double a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
  double c = fx * fx + fy * fy + fz * fz - {r} * {r};
  double x[2];
  int count = 0;
  vtkPolynomialSolversUnivariate::SolveQuadratic(a, b, c, &x[0], &x[1], &count);
  if (count == 0) return std::puts("miss"), 0;
  auto [s0, s1] = std::minmax({x[0], x[count - 1]});
  double s = s0 >= 0 ? s0 : s1;
  s >= 0 ? std::printf("%.17g\n", s) : std::puts("miss");
}
