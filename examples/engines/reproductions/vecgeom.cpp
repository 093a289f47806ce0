// g++ -DNDEBUG -DVECCORE_ENABLE_VC case.cpp -lvecgeom -o case
#include <VecGeom/volumes/UnplacedOrb.h>
#include <cstdio>
int main() {
  // Its spheres lie at (0, 0, 0).
  vecgeom::Vector3D<double> origin({ox} - {cx}, {oy} - {cy}, {oz} - {cz});
  vecgeom::Vector3D<double> direction({dx}, {dy}, {dz});
  vecgeom::UnplacedOrb orb({r});
  double s = orb.DistanceToIn(origin, direction, vecgeom::kInfLength);
  if (s < 0) s = orb.DistanceToOut(origin, direction, vecgeom::kInfLength);
  s >= 0 && s < vecgeom::kInfLength ? std::printf("%.17g\n", s) : std::puts("miss");
}
