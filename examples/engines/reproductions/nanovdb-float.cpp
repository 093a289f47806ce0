// g++ -std=c++17 case.cpp -o case
#include <nanovdb/util/Ray.h>
#include <cstdio>
int main() {
  using Vec = nanovdb::Vec3<float>;
  nanovdb::Ray<float> ray(Vec(float({ox}), float({oy}), float({oz})), Vec(float({dx}), float({dy}), float({dz})));
  float t0, t1;
  bool hit = ray.intersects(Vec(float({cx}), float({cy}), float({cz})), {r}, t0, t1);
  hit ? std::printf("%.9g\n", t0 != ray.t0() ? t0 : t1) : std::puts("miss");
}
