// g++ case.cpp -I/usr/include/simbody -lSimTKmath -o case
#include <SimTKmath.h>
#include <cstdio>
int main() {
  SimTK::Vec3 origin({ox} - {cx}, {oy} - {cy}, {oz} - {cz});  // its spheres lie at (0, 0, 0)
  SimTK::Real distance = 0;
  SimTK::UnitVec3 direction(SimTK::Vec3({dx}, {dy}, {dz})), normal;
  bool hit = SimTK::ContactGeometry::Sphere({r}).intersectsRay(origin, direction, distance, normal);
  hit ? std::printf("%.17g\n", distance) : std::puts("miss");
}
