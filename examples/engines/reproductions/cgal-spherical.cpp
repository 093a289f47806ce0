// g++ case.cpp -lgmp -o case
#include <CGAL/Exact_spherical_kernel_3.h>
#include <cstdio>
using K = CGAL::Exact_spherical_kernel_3;
int main() {
  K::Line_3 line(K::Point_3({ox}, {oy}, {oz}), K::Vector_3({dx}, {dy}, {dz}));
  K::Sphere_3 sphere(K::Point_3({cx}, {cy}, {cz}), CGAL::square(K::FT({r})));
  std::vector<CGAL::SK3_Intersection_traits<K, K::Line_3, K::Sphere_3>::type> points;
  CGAL::intersection(line, sphere, std::back_inserter(points));  // in lexicographic order
  if (points.empty()) return std::puts("miss"), 0;
  bool forward = {dx} > 0 || ({dx} == 0 && ({dy} > 0 || ({dy} == 0 && {dz} > 0)));
  auto first = forward ? points.front() : points.back();
  using boost::get, std::get;  // CGAL 5 has Boost's variants, CGAL 6 those of the standard library
  auto p = get<std::pair<K::Circular_arc_point_3, unsigned>>(first).first;
  std::printf("%.17g %.17g %.17g\n", CGAL::to_double(p.x()), CGAL::to_double(p.y()),
              CGAL::to_double(p.z()));
}
