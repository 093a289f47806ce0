// g++ case.cpp -l:libBALL.so.1.5 -o case
#include <BALL/MATHS/analyticalGeometry.h>
#include <cstdio>
int main() {
  using Point = BALL::TVector3<double>;
  Point d({dx}, {dy}, {dz}), p, q;
  BALL::TLine3<double> line(Point({ox}, {oy}, {oz}), d);
  bool hit = BALL::GetIntersection(BALL::TSphere3<double>(Point({cx}, {cy}, {cz}), {r}), line, p, q);
  if ((q - p) * d < 0) p = q;
  hit ? std::printf("%.17g %.17g %.17g\n", p.x, p.y, p.z) : std::puts("miss");
}
