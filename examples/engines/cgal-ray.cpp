// CGAL's do_intersect(Ray_3, Sphere_3) of Simple_cartesian<double>: whether the ray intersects the
// sphere; a tangent counts. Debian: libcgal-dev. Source: the manual, "2D and 3D Linear Geometry
// Kernel", do_intersect(). This kernel's predicates are rounded. Its spheres have squared radii;
// the adapter's r * r is rounded.

#include <CGAL/Simple_cartesian.h>

#include "adapter.h"

using namespace raycheck;
#ifndef KERNEL
#define KERNEL CGAL::Simple_cartesian<double>
#endif
using Kernel = KERNEL;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const Kernel::Ray_3 line(to<Kernel::Point_3>(ray.origin), to<Kernel::Vector_3>(ray.direction));
  const Kernel::Sphere_3 ball(to<Kernel::Point_3>(sphere.centre), sphere.radius * sphere.radius);
  if (!CGAL::do_intersect(line, ball)) return std::nullopt;
  return Hit{};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::hit, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .returns = Returns::class_only)
