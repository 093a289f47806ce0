// g++ case.cpp -lgsl -lgslcblas -o case
#include <gsl/gsl_poly.h>
#include <cstdio>
int main() {
  double fx = {ox} - {cx}, fy = {oy} - {cy}, fz = {oz} - {cz};
  double a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
  double c = fx * fx + fy * fy + fz * fz - {r} * {r};
  double s0 = 0, s1 = 0;
  int count = gsl_poly_solve_quadratic(a, b, c, &s0, &s1);
  double s = s0 >= 0 ? s0 : s1;
  count == 2 && s >= 0 ? std::printf("%.17g\n", s) : std::puts("miss");
}
