// g++ case.cpp -lopenvdb -o case
#include <openvdb/math/Ray.h>
#include <cstdio>
int main() {
  openvdb::Vec3d origin({ox}, {oy}, {oz}), direction({dx}, {dy}, {dz});
  openvdb::math::Ray<double> ray(origin, direction);
  std::puts(ray.intersects(openvdb::Vec3d({cx}, {cy}, {cz}), {r}) ? "hit" : "miss");
}
