// g++ case.cpp -lCoin -o case
#include <Inventor/SbLine.h>
#include <Inventor/SbSphere.h>
#include <cstdio>
int main() {
  SbLine line;
  line.setPosDir(SbVec3f({ox}, {oy}, {oz}), SbVec3f({dx}, {dy}, {dz}));
  SbVec3f p, q;
  bool hit = SbSphere(SbVec3f({cx}, {cy}, {cz}), {r}).intersect(line, p, q);
  hit ? std::printf("%.9g %.9g %.9g\n", p[0], p[1], p[2]) : std::puts("miss");
}
