// Simbody's PolynomialRootFinder::findRoots for the textbook's rounded coefficients. Debian:
// libsimbody-dev; -lSimTKcommon.
// Source: SimTKcommon/internal/PolynomialRootFinder.h. Returns two complex roots, in no promised
// order; roots with the imaginary part 0 are real.

#include <SimTKcommon/internal/PolynomialRootFinder.h>

#include <algorithm>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere,
                                    const Conventions& asked) {
  const Quadratic q(ray, sphere);
  SimTK::Vec<2, SimTK::Complex> roots;
  SimTK::PolynomialRootFinder::findRoots(SimTK::Vec3(q.a, q.b, q.c), roots);
  if (roots[0].imag() != 0) return std::nullopt;
  const auto [smaller, larger] = std::minmax({roots[0].real(), roots[1].real()});
  return chosen(ray, smaller, larger, asked);
}

RAYCHECK_CANDIDATE(.tangent = Tangent::hit, .intersect = intersect, .level = Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest)
