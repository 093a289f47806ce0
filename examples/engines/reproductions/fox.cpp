// g++ case.cpp -lFOX-1.6 -o case
#include <fox-1.6/fx.h>
#include <fox-1.6/fx3d.h>
#include <cstdio>
int main() {
  FX::FXVec3d o({ox}, {oy}, {oz}), d({dx}, {dy}, {dz});
  std::puts(FX::FXSphered(FX::FXVec3d({cx}, {cy}, {cz}), {r}).intersect(o, o + d) ? "hit" : "miss");
}
