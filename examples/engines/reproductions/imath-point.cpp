// g++ case.cpp -o case
#include <Imath/ImathLine.h>
#include <Imath/ImathSphere.h>
#include <cstdio>
int main() {
  Imath::Line3f line;
  line.pos = Imath::V3f({ox}, {oy}, {oz});
  line.dir = Imath::V3f({dx}, {dy}, {dz});
  Imath::V3f p;
  bool hit = Imath::Sphere3f(Imath::V3f({cx}, {cy}, {cz}), {r}).intersect(line, p);
  hit ? std::printf("%.9g %.9g %.9g\n", p.x, p.y, p.z) : std::puts("miss");
}
