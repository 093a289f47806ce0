// g++ case.cpp -lWm5Mathematics -lWm5Core -o case
#include <libwildmagic/Wm5IntrLine3Sphere3.h>
#include <cstdio>
int main() {
  Wm5::Line3d line(Wm5::Vector3d({ox}, {oy}, {oz}), Wm5::Vector3d({dx}, {dy}, {dz}));
  Wm5::Sphere3d sphere(Wm5::Vector3d({cx}, {cy}, {cz}), {r});
  Wm5::IntrLine3Sphere3d points(line, sphere);
  bool hit = points.Find() && points.GetQuantity() > 0;
  hit ? std::printf("%.17g\n", points.GetLineParameter(0)) : std::puts("miss");
}
