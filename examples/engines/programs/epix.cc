// g++ {} -L/usr/lib/$(gcc -print-multiarch)/epix -lepix -o epix && ./epix
// ePiX's operator*(Segment, Sphere), in doubles: the chord that the segment's line cuts from the
// sphere, or a malformed Segment. Debian: epix, whose library is static and not
// position-independent. Source: epix/intersections.h. Silent on tangents and on the order of the
// points; the adapter takes the first along the line. Its points are given by raycheck.
// raycheck rays end
// raycheck roots [] -inf inf absolute none
// raycheck returns point
// raycheck root nearest
// raycheck tangent either
// raycheck level ordinary
#include <epix.h>

#include <cstdio>

using ePiX::P;

int main() {
  double x[10];
  while (std::scanf("%lf%lf%lf%lf%lf%lf%lf%lf%lf%lf", x, x + 1, x + 2, x + 3, x + 4, x + 5, x + 6,
                    x + 7, x + 8, x + 9) == 10) {
    const P start(x[0], x[1], x[2]), end(x[3], x[4], x[5]);
    const ePiX::Segment chord = ePiX::Segment(start, end) * ePiX::Sphere(P(x[6], x[7], x[8]), x[9]);
    if (chord.malformed()) {
      std::puts("= miss");
    } else {
      const P p = chord.end1(), q = chord.end2(), first = ((q - p) | (end - start)) < 0 ? q : p;
      std::printf("= %.17g %.17g %.17g\n", first.x1(), first.x2(), first.x3());
    }
    std::fflush(stdout);
  }
}
