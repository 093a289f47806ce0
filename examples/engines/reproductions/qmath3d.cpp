// g++ case.cpp -fPIC $(pkg-config --cflags --libs Qt5Gui) -lQMath3d -o case
#include <qray3d.h>
#include <qsphere3d.h>
#include <cmath>
#include <cstdio>
int main() {
  QRay3D ray(QVector3D({ox}, {oy}, {oz}), QVector3D({dx}, {dy}, {dz}));
  float t = QSphere3D(QVector3D({cx}, {cy}, {cz}), {r}).intersection(ray);
  std::isnan(t) ? std::puts("miss") : std::printf("%.9g\n", t);
}
