// g++ case.cpp -lopenvdb -ltbb -o case
#include <openvdb/math/Ray.h>
#include <cstdio>
int main() {
  openvdb::math::Ray<double> ray(openvdb::Vec3d({ox}, {oy}, {oz}), openvdb::Vec3d({dx}, {dy}, {dz}));
  std::puts(ray.intersects(openvdb::Vec3d({cx}, {cy}, {cz}), {r}) ? "hit" : "miss");
}
