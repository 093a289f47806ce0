// g++ case.cpp -I/usr/include/eigen3 -lgeometric_shapes -o case
#include <geometric_shapes/bodies.h>
#include <geometric_shapes/shapes.h>
#include <cstdio>
int main() {
  shapes::Sphere shape({r});
  bodies::Sphere ball(&shape);
  ball.setPose(Eigen::Isometry3d(Eigen::Translation3d({cx}, {cy}, {cz})));
  EigenSTL::vector_Vector3d p;
  bool hit = ball.intersectsRay(Eigen::Vector3d({ox}, {oy}, {oz}),
                                Eigen::Vector3d({dx}, {dy}, {dz}), &p, 1);
  hit ? std::printf("%.17g %.17g %.17g\n", p[0].x(), p[0].y(), p[0].z()) : std::puts("miss");
}
