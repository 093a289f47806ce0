// g++ case.cpp -o case
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
#include <cstdio>
int main() {
  glm::dvec3 origin({ox}, {oy}, {oz}), direction({dx}, {dy}, {dz}), centre({cx}, {cy}, {cz});
  glm::dvec3 p, normal;
  bool hit = glm::intersectRaySphere(origin, direction, centre, {r}, p, normal);
  hit ? std::printf("%.17g %.17g %.17g\n", p.x, p.y, p.z) : std::puts("miss");
}
