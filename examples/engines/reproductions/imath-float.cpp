// g++ case.cpp -o case
#include <Imath/ImathLine.h>
#include <Imath/ImathSphere.h>
#include <cstdio>
int main() {
  Imath::Line3f line;
  line.pos = Imath::V3f({ox}, {oy}, {oz});
  line.dir = Imath::V3f({dx}, {dy}, {dz});
  float t = 0;
  bool hit = Imath::Sphere3f(Imath::V3f({cx}, {cy}, {cz}), {r}).intersectT(line, t);
  hit ? std::printf("%.9g\n", t) : std::puts("miss");
}
