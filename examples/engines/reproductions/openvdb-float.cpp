// g++ case.cpp -lopenvdb -o case
#include <openvdb/math/Ray.h>
#include <cstdio>
using Vec = openvdb::math::Vec3<float>;
int main() {
  openvdb::math::Ray<float> ray(Vec({ox}, {oy}, {oz}), Vec({dx}, {dy}, {dz}));
  float t0 = 0, t1 = 0;
  bool hit = ray.intersects(Vec({cx}, {cy}, {cz}), {r}, t0, t1);
  float t = t0 == ray.t0() ? t1 : t0;  // a clipped value is not an intersection
  hit && t != ray.t1() ? std::printf("%.9g\n", t) : std::puts("miss");
}
