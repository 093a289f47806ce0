// g++ case.cpp -I/usr/include/eigen3 -o case
#include <unsupported/Eigen/Polynomials>
#include <cstdio>
int main() {
  double fx = {ox} - {cx}, fy = {oy} - {cy}, fz = {oz} - {cz};
  double a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
  double c = fx * fx + fy * fy + fz * fz - {r} * {r};
  Eigen::PolynomialSolver<double, 2> solver(Eigen::Vector3d(c, b, a));
  bool real = false;
  double s0 = solver.smallestRealRoot(real), s1 = solver.greatestRealRoot(real);
  double s = s0 >= 0 ? s0 : s1;
  real && s >= 0 ? std::printf("%.17g\n", s) : std::puts("miss");
}
