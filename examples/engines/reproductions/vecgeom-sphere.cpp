// g++ -DNDEBUG -DVECCORE_ENABLE_VC case.cpp -lvecgeom -o case
#include <VecGeom/volumes/UnplacedSphere.h>
#include <cstdio>
int main() {
  // Its spheres lie at (0, 0, 0).
  vecgeom::Vector3D<double> origin({ox} - {cx}, {oy} - {cy}, {oz} - {cz});
  vecgeom::Vector3D<double> direction({dx}, {dy}, {dz});
  vecgeom::UnplacedSphere ball(0, {r});
  double s = ball.Inside(origin) == vecgeom::kInside
                 ? ball.DistanceToOut(origin, direction, vecgeom::kInfLength)
                 : ball.DistanceToIn(origin, direction, vecgeom::kInfLength);
  s >= 0 && s < vecgeom::kInfLength ? std::printf("%.17g\n", s) : std::puts("miss");
}
