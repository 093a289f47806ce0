// NAME, a candidate for raycheck: call your function below, and declare its conventions at the end.

#include <raycheck/candidate.hpp>
#include <stdexcept>

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  // ray.origin, ray.direction, sphere.centre (x, y, z) and sphere.radius are doubles. Return
  // std::nullopt for a miss, or Hit{s, {x, y, z}} with the point at origin + s direction.
  (void)ray, (void)sphere;
  throw std::runtime_error("NAME: calls nothing yet");
}

// Root::nearest is the smallest s >= 0, Root::smaller always v - d. Add what applies to your code,
// in this order: .precision = Precision::single if it computes in floats; .roots = Roots::declared
// and .valid = {.t_min = 1e-3, .ends = Ends::open, .unit = TUnit::length} if it ignores hits nearer
// than 1e-3; .directions = Directions::unit if it requires unit directions; .returns =
// Returns::parameter, point, distance, squared_distance, class_only (it declares its root, too) or
// roots. If your code has a type Ray, too, write ::Ray for it and raycheck::Ray above.
RAYCHECK_CANDIDATE(.name = "NAME", .root = Root::nearest, .tangent = Tangent::either,
                   .intersect = intersect)
