// VTK's vtkPolynomialSolversUnivariate::SolveQuadratic for the textbook's rounded coefficients.
// Debian: libvtk9-dev; -lvtkCommonMath.
// Source: vtkPolynomialSolversUnivariate.h. Returns the number of real roots, where a double root
// counts once, and the roots, in no promised order.

#include <vtkPolynomialSolversUnivariate.h>

#include <algorithm>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere,
                                    const Conventions& asked) {
  const Quadratic q(ray, sphere);
  double r1 = 0, r2 = 0;
  int count = 0;
  vtkPolynomialSolversUnivariate::SolveQuadratic(q.a, q.b, q.c, &r1, &r2, &count);
  if (count == 0) return std::nullopt;
  if (count == 1) r2 = r1;
  return chosen(ray, std::min(r1, r2), std::max(r1, r2), asked);
}

RAYCHECK_CANDIDATE(.tangent = Tangent::hit, .intersect = intersect, .level = Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest)
