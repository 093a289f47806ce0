// g++ case.cpp -fPIC $(pkg-config --cflags --libs Qt5Gui) -lQMath3d -o case
#include <qray3d.h>
#include <qsphere3d.h>
#include <cstdio>
int main() {
  QRay3D ray(QVector3D({ox}, {oy}, {oz}), QVector3D({dx}, {dy}, {dz}));
  float t, far;
  bool hit = QSphere3D(QVector3D({cx}, {cy}, {cz}), {r}).intersection(ray, &t, &far);
  hit && far >= 0 ? std::printf("%.9g\n", t >= 0 ? t : far) : std::puts("miss");
}
