// Boost.Math's quadratic_roots of the textbook's rounded coefficients. Debian: libboost-dev.

#include <boost/math/tools/roots.hpp>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere,
                                    const Conventions& asked) {
  const Quadratic q(ray, sphere);
  const auto [smaller, larger] = boost::math::tools::quadratic_roots(q.a, q.b, q.c);
  return chosen(ray, smaller, larger, asked);
}

RAYCHECK_CANDIDATE(.name = "boost-math", .tangent = Tangent::hit, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest)
