// Eigen's PolynomialSolver for the textbook's rounded coefficients: eigenvalues of a companion
// matrix. Debian: libeigen3-dev.
// Source: unsupported/Eigen/Polynomials, smallestRealRoot(). Roots whose imaginary part is at most
// 1e-12 count as real; the adapter's lengths are far above this.

#include <unsupported/Eigen/Polynomials>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere,
                                    const Conventions& asked) {
  const Quadratic q(ray, sphere);
  const Eigen::PolynomialSolver<double, 2> solver(Eigen::Vector3d(q.c, q.b, q.a));
  bool real = false;
  const double smaller = solver.smallestRealRoot(real), larger = solver.greatestRealRoot(real);
  if (!real) return std::nullopt;
  return chosen(ray, smaller, larger, asked);
}

RAYCHECK_CANDIDATE(.tangent = Tangent::hit, .intersect = intersect, .level = Level::ordinary,
                   .smallest_length = 0x1p-10, .largest_length = kLargest,
                   .directions = Directions::unit)
