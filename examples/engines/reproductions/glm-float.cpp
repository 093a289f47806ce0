// g++ case.cpp -o case
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
#include <cstdio>
int main() {
  glm::vec3 origin({ox}, {oy}, {oz}), direction({dx}, {dy}, {dz}), centre({cx}, {cy}, {cz});
  float r = {r}, distance = 0;
  bool hit = glm::intersectRaySphere(origin, direction, centre, r * r, distance);
  hit ? std::printf("%.9g\n", distance) : std::puts("miss");
}
