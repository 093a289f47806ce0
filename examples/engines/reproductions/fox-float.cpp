// g++ case.cpp -lFOX-1.6 -o case
#include <fox-1.6/fx.h>
#include <fox-1.6/fx3d.h>
#include <cstdio>
int main() {
  FX::FXVec3f o({ox}, {oy}, {oz}), d({dx}, {dy}, {dz});
  std::puts(FX::FXSpheref(FX::FXVec3f({cx}, {cy}, {cz}), {r}).intersect(o, o + d) ? "hit" : "miss");
}
