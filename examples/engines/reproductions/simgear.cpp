// g++ case.cpp -o case
#include <simgear/math/SGGeometry.hxx>
#include <cstdio>
int main() {
  SGRayd ray(SGVec3d({ox}, {oy}, {oz}), SGVec3d({dx}, {dy}, {dz}));
  std::puts(intersects(ray, SGSphered(SGVec3d({cx}, {cy}, {cz}), {r})) ? "hit" : "miss");
}
