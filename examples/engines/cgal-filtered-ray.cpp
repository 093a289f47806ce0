// CGAL's do_intersect(Ray_3, Sphere_3) of Exact_predicates_inexact_constructions_kernel: its sign
// is that of exact numbers, for a ray whose second point and a sphere whose squared radius are
// rounded.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#define KERNEL CGAL::Exact_predicates_inexact_constructions_kernel
#include "cgal-ray.cpp"
