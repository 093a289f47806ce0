// g++ case.cpp -I/usr/include/opencascade -lTKGeomBase -lTKMath -lTKernel -o case
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <IntAna_Quadric.hxx>
#include <IntAna_IntConicQuad.hxx>
#include <algorithm>
#include <cstdio>
int main() {
  gp_Lin line(gp_Pnt({ox}, {oy}, {oz}), gp_Dir({dx}, {dy}, {dz}));
  gp_Sphere sphere(gp_Ax3(gp_Pnt({cx}, {cy}, {cz}), gp::DZ()), {r});
  IntAna_IntConicQuad points(line, IntAna_Quadric(sphere));
  if (!points.IsDone() || points.NbPoints() == 0) return std::puts("miss"), 0;
  std::printf("%.17g\n", std::min(points.ParamOnConic(1), points.ParamOnConic(points.NbPoints())));
}
