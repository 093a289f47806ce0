// CGAL's do_intersect(Ray_3, Sphere_3) of Exact_predicates_inexact_constructions_kernel. It decides
// exactly, but for a ray whose second point is rounded and a sphere whose squared radius is
// rounded.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#define KERNEL CGAL::Exact_predicates_inexact_constructions_kernel
#include "cgal-ray.cpp"
