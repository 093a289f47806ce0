// g++ case.cpp -lode -o case
#include <ode/ode.h>
#include <cstdio>
int main() {
  dInitODE2(0);
  dGeomID ray = dCreateRay(nullptr, dInfinity), sphere = dCreateSphere(nullptr, {r});
  dGeomRaySet(ray, {ox}, {oy}, {oz}, {dx}, {dy}, {dz});
  dGeomSetPosition(sphere, {cx}, {cy}, {cz});
  dContactGeom contact;
  int contacts = dCollide(ray, sphere, 1, &contact, sizeof contact);
  contacts ? std::printf("%.17g\n", contact.depth) : std::puts("miss");
}
