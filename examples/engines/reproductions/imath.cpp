// g++ case.cpp -o case
#include <Imath/ImathLine.h>
#include <Imath/ImathSphere.h>
#include <cstdio>
int main() {
  Imath::Line3d line;
  line.pos = Imath::V3d({ox}, {oy}, {oz});
  line.dir = Imath::V3d({dx}, {dy}, {dz});
  double t = 0;
  bool hit = Imath::Sphere3d(Imath::V3d({cx}, {cy}, {cz}), {r}).intersectT(line, t);
  hit ? std::printf("%.17g\n", t) : std::puts("miss");
}
