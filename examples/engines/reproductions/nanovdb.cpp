// g++ -std=c++17 case.cpp -o case
#include <nanovdb/util/Ray.h>
#include <cstdio>
int main() {
  using Vec = nanovdb::Vec3<double>;
  nanovdb::Ray<double> ray(Vec({ox}, {oy}, {oz}), Vec({dx}, {dy}, {dz}));
  double t0, t1;
  bool hit = ray.intersects(Vec({cx}, {cy}, {cz}), {r}, t0, t1);
  hit ? std::printf("%.17g\n", t0 != ray.t0() ? t0 : t1) : std::puts("miss");
}
