// g++ case.cpp -o case
#include <boost/math/tools/roots.hpp>
#include <cstdio>
int main() {
  double fx = {ox} - {cx}, fy = {oy} - {cy}, fz = {oz} - {cz};
  double a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
  double c = fx * fx + fy * fy + fz * fz - {r} * {r};
  auto [s0, s1] = boost::math::tools::quadratic_roots(a, b, c);
  double s = s0 >= 0 ? s0 : s1;
  s >= 0 ? std::printf("%.17g\n", s) : std::puts("miss");
}
