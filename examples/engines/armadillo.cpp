// Armadillo's roots() for the textbook's rounded coefficients: eigenvalues of a companion matrix.
// Debian: libarmadillo-dev; -larmadillo.
// Source: arma.sourceforge.net/docs.html#roots. Returns complex roots, in no promised order; roots
// with the imaginary part 0 are real.

#include <algorithm>
#include <armadillo>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere,
                                    const Conventions& asked) {
  const Quadratic q(ray, sphere);
  arma::cx_vec roots;
  if (!arma::roots(roots, arma::vec{q.a, q.b, q.c})) return std::nullopt;
  if (roots.n_elem == 0 || roots.front().imag() != 0) return std::nullopt;
  const auto [smaller, larger] = std::minmax({roots.front().real(), roots.back().real()});
  return chosen(ray, smaller, larger, asked);
}

RAYCHECK_CANDIDATE(.tangent = Tangent::either, .intersect = intersect, .level = Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest)
