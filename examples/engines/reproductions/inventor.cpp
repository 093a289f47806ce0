// g++ case.cpp -l:libInventor.so.1 -o case
#include <cstdio>
struct SbVec3f { float x, y, z; };  // as in Inventor/SbLinear.h of inventor-dev
struct SbLine { SbLine(const SbVec3f&, const SbVec3f&); SbVec3f position, direction; };
struct SbSphere {
  SbSphere(const SbVec3f&, float);
  int intersect(const SbLine&, SbVec3f&, SbVec3f&) const;
  SbVec3f centre;
  float radius;
};
int main() {
  float o[] = { {ox}, {oy}, {oz} }, d[] = { {dx}, {dy}, {dz} };
  SbLine line({o[0], o[1], o[2]}, {o[0] + d[0], o[1] + d[1], o[2] + d[2]});
  SbVec3f p, q;
  int hit = SbSphere({ {cx}, {cy}, {cz} }, {r}).intersect(line, p, q);
  hit ? std::printf("%.9g %.9g %.9g\n", p.x, p.y, p.z) : std::puts("miss");
}
