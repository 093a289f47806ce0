// CGAL's do_intersect(Ray_3, Sphere_3) of Exact_predicates_exact_constructions_kernel: whether the
// ray intersects the sphere, exactly; a tangent counts. Debian: libcgal-dev; -lgmp -lmpfr.
// Source: the manual, "2D and 3D Linear Geometry Kernel", do_intersect(). Squared radii are exact
// numbers of this kernel.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "adapter.h"

using namespace raycheck;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const Kernel::Ray_3 line(to<Kernel::Point_3>(ray.origin), to<Kernel::Vector_3>(ray.direction));
  const Kernel::Sphere_3 ball(to<Kernel::Point_3>(sphere.centre),
                              CGAL::square(Kernel::FT(sphere.radius)));
  if (!CGAL::do_intersect(line, ball)) return std::nullopt;
  return Hit{};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::hit, .intersect = intersect,
                   .level = Level::extreme, .returns = Returns::class_only)
