// g++ case.cpp -o case
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
#include <cstdio>
int main() {
  glm::dvec3 origin({ox}, {oy}, {oz}), direction({dx}, {dy}, {dz}), centre({cx}, {cy}, {cz});
  double r = {r}, distance = 0;
  bool hit = glm::intersectRaySphere(origin, direction, centre, r * r, distance);
  hit ? std::printf("%.17g\n", distance) : std::puts("miss");
}
