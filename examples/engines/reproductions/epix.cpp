// g++ case.cpp -L/usr/lib/$(gcc -print-multiarch)/epix -lepix -o case
#include <epix.h>
#include <cstdio>
int main() {
  ePiX::P o({ox}, {oy}, {oz}), d({dx}, {dy}, {dz});
  ePiX::Segment chord = ePiX::Segment(o, o + d) * ePiX::Sphere(ePiX::P({cx}, {cy}, {cz}), {r});
  if (chord.malformed()) return std::puts("miss"), 0;
  ePiX::P p = chord.end1(), q = chord.end2();
  if (((q - p) | d) < 0) p = q;
  std::printf("%.17g %.17g %.17g\n", p.x1(), p.x2(), p.x3());
}
