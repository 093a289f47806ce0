// g++ case.cpp -lgmp -o case
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <cstdio>
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
int main() {
  Kernel::Ray_3 ray(Kernel::Point_3({ox}, {oy}, {oz}), Kernel::Vector_3({dx}, {dy}, {dz}));
  Kernel::Sphere_3 sphere(Kernel::Point_3({cx}, {cy}, {cz}), {r} * {r});
  std::puts(CGAL::do_intersect(ray, sphere) ? "hit" : "miss");
}
