// CGAL's intersection(Line_3, Sphere_3) of Exact_spherical_kernel_3: both points, exact, in
// lexicographic order. Debian: libcgal-dev; -lgmp -lmpfr. Source: the manual, "3D Spherical
// Geometry Kernel", intersection(). A tangent is one point of multiplicity 2. The adapter calls
// to_double(), for which no error bound is given.

#include <CGAL/Exact_spherical_kernel_3.h>

#include <iterator>
#include <utility>
#include <vector>

#include "adapter.h"

using namespace raycheck;
using Kernel = CGAL::Exact_spherical_kernel_3;
using Point = Kernel::Point_3;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const auto& d = ray.direction;
  const Kernel::Line_3 line(to<Point>(ray.origin), to<Kernel::Vector_3>(d));
  const Kernel::Sphere_3 ball(to<Point>(sphere.centre), CGAL::square(Kernel::FT(sphere.radius)));
  std::vector<CGAL::SK3_Intersection_traits<Kernel, Kernel::Line_3, Kernel::Sphere_3>::type> both;
  CGAL::intersection(line, ball, std::back_inserter(both));
  if (both.empty()) return std::nullopt;
  const bool forward = d.x > 0 || (d.x == 0 && (d.y > 0 || (d.y == 0 && d.z > 0)));
  using Counted = std::pair<Kernel::Circular_arc_point_3, unsigned>;
  using boost::get, std::get;  // CGAL 5 has Boost's variants, CGAL 6 those of the standard library
  const auto point = get<Counted>(forward ? both.front() : both.back()).first;
  return Hit{.point = {CGAL::to_double(point.x()), CGAL::to_double(point.y()),
                       CGAL::to_double(point.z())}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::hit, .intersect = intersect,
                   .level = Level::demanding, .smallest_length = kSmallest,
                   .largest_length = kLargest, .roots = Roots::declared, .valid = kLine,
                   .returns = Returns::point)
