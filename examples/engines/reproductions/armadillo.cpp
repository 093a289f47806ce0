// g++ case.cpp -larmadillo -o case
#include <algorithm>
#include <armadillo>
#include <cstdio>
int main() {
  double fx = {ox} - {cx}, fy = {oy} - {cy}, fz = {oz} - {cz};
  double a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
  double c = fx * fx + fy * fy + fz * fz - {r} * {r};
  arma::cx_vec x = arma::roots(arma::vec{a, b, c});
  double s0 = std::min(x[0].real(), x[1].real());
  double s1 = std::max(x[0].real(), x[1].real()), s = s0 >= 0 ? s0 : s1;
  x[0].imag() == 0 && s >= 0 ? std::printf("%.17g\n", s) : std::puts("miss");
}
