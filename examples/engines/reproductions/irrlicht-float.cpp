// g++ case.cpp -o case
#include <irrlicht/line3d.h>
#include <cstdio>
using Point = irr::core::vector3d<irr::f32>;
int main() {
  Point from({ox}, {oy}, {oz});
  Point to = from + Point({dx}, {dy}, {dz}) * 0x1p30;  // so far that it does not turn the line
  double s = 0;  // in doubles for either
  irr::core::line3d<irr::f32> line(from, to);
  bool hit = line.getIntersectionWithSphere(Point({cx}, {cy}, {cz}), {r}, s);
  hit ? std::printf("%.17g\n", s) : std::puts("miss");
}
