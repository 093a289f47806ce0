// geometric_shapes' (ROS, MoveIt) bodies::Sphere::intersectsRay, in doubles: the intersections in
// order along the ray; one is requested. Debian: libgeometric-shapes-dev; -lgeometric_shapes.
// Source: geometric_shapes/bodies.h: unit directions are only faster (with the macro UNIT, the
// adapter takes them as required). It does not mention tangents, nor its epsilon, an absolute 1e-9.

#include <geometric_shapes/bodies.h>
#include <geometric_shapes/shapes.h>

#include "adapter.h"

using namespace raycheck;
using Eigen::Vector3d;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const shapes::Sphere shape(sphere.radius);
  bodies::Sphere ball(&shape);
  ball.setPose(Eigen::Isometry3d(Eigen::Translation3d(to<Vector3d>(sphere.centre))));
  EigenSTL::vector_Vector3d points;
  if (!ball.intersectsRay(to<Vector3d>(ray.origin), to<Vector3d>(ray.direction), &points, 1)) {
    return std::nullopt;
  }
  return Hit{.point = {points[0].x(), points[0].y(), points[0].z()}};
}

#ifdef UNIT
constexpr Directions kDirections = Directions::unit;
#else
constexpr Directions kDirections = Directions::any;
#endif
RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .directions = kDirections, .returns = Returns::point)
