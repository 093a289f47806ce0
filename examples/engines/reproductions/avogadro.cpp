// g++ -std=c++17 -I/usr/include/eigen3 case.cpp -lAvogadroRendering -o case
#include <avogadro/rendering/spheregeometry.h>
#include <cstdio>
int main() {
  using Avogadro::Vector3f;
  Avogadro::Rendering::SphereGeometry spheres;
  spheres.identifier().type = Avogadro::Rendering::AtomType;
  spheres.addSphere(Vector3f({cx}, {cy}, {cz}), {}, {r});
  Vector3f o({ox}, {oy}, {oz}), d({dx}, {dy}, {dz});
  std::puts(spheres.hits(o, o + 1e9f * d, d).empty() ? "miss" : "hit");
}
