// g++ case.cpp -lopenvdb -o case
#include <openvdb/math/Ray.h>
#include <cstdio>
using Vec = openvdb::math::Vec3<double>;
int main() {
  openvdb::math::Ray<double> ray(Vec({ox}, {oy}, {oz}), Vec({dx}, {dy}, {dz}));
  double t0 = 0, t1 = 0;
  bool hit = ray.intersects(Vec({cx}, {cy}, {cz}), {r}, t0, t1);
  double t = t0 == ray.t0() ? t1 : t0;  // a clipped value is not an intersection
  hit && t != ray.t1() ? std::printf("%.17g\n", t) : std::puts("miss");
}
