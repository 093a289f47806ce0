// g++ case.cpp -lWm5Mathematics -lWm5Core -o case
#include <libwildmagic/Wm5IntrRay3Sphere3.h>
#include <cstdio>
int main() {
  Wm5::Ray3f line(Wm5::Vector3f({ox}, {oy}, {oz}), Wm5::Vector3f({dx}, {dy}, {dz}));
  Wm5::Sphere3f sphere(Wm5::Vector3f({cx}, {cy}, {cz}), {r});
  Wm5::IntrRay3Sphere3f points(line, sphere);
  bool hit = points.Find() && points.GetQuantity() > 0;
  hit ? std::printf("%.9g\n", points.GetRayParameter(0)) : std::puts("miss");
}
