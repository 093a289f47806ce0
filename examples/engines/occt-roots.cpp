// Open CASCADE's math_DirectPolynomialRoots for the textbook's rounded coefficients. Debian:
// libocct-foundation-dev; -lTKMath -lTKernel.
// Source: opencascade/math_DirectPolynomialRoots.hxx: the real roots of A x^2 + B x + C, in no
// promised order.

#include <algorithm>
#include <math_DirectPolynomialRoots.hxx>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere,
                                    const Conventions& asked) {
  const Quadratic q(ray, sphere);
  const math_DirectPolynomialRoots roots(q.a, q.b, q.c);
  if (!roots.IsDone() || roots.NbSolutions() == 0) return std::nullopt;
  const auto [smaller, larger] = std::minmax({roots.Value(1), roots.Value(roots.NbSolutions())});
  return chosen(ray, smaller, larger, asked);
}

RAYCHECK_CANDIDATE(.tangent = Tangent::hit, .intersect = intersect, .level = Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest,
                   .directions = Directions::unit)
