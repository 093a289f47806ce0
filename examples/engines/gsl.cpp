// GSL's gsl_poly_solve_quadratic of the textbook's rounded coefficients. Debian: libgsl-dev.

#include <gsl/gsl_poly.h>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere,
                                    const Conventions& asked) {
  const Quadratic q(ray, sphere);
  double smaller = 0, larger = 0;
  // GSL returns a double root as two equal roots.
  if (gsl_poly_solve_quadratic(q.a, q.b, q.c, &smaller, &larger) != 2) return std::nullopt;
  return chosen(ray, smaller, larger, asked);
}

RAYCHECK_CANDIDATE(.name = "gsl", .tangent = Tangent::hit, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest)
