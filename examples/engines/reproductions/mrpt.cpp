// g++ case.cpp -I/usr/include/eigen3 $(ls -d /usr/include/mrpt/*/include | sed s/^/-I/) -lmrpt-opengl -lmrpt-poses -lmrpt-math -o case
#include <mrpt/opengl/CSphere.h>
#include <mrpt/poses/CPose3D.h>
#include <cmath>
#include <cstdio>
int main() {
  mrpt::math::TVector3D x = mrpt::math::TVector3D({dx}, {dy}, {dz}).unitarize();
  bool flat = std::abs(x.z) < 0.5;
  mrpt::math::TVector3D y = mrpt::math::TVector3D(flat ? -x.y : 0, flat ? x.x : -x.z, flat ? 0 : x.y).unitarize();
  mrpt::math::TVector3D z(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
  mrpt::math::CMatrixDouble33 axes;
  for (int i = 0; i < 3; ++i) axes(i, 0) = x[i], axes(i, 1) = y[i], axes(i, 2) = z[i];
  mrpt::opengl::CSphere ball({r});
  ball.setLocation({cx}, {cy}, {cz});
  double s;
  bool hit = ball.traceRay({axes, mrpt::math::CVectorFixedDouble<3>({ {ox}, {oy}, {oz} })}, s);
  hit ? std::printf("%.17g\n", s) : std::puts("miss");
}
