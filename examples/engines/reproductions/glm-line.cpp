// g++ case.cpp -o case
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
#include <cstdio>
int main() {
  glm::dvec3 from({ox}, {oy}, {oz}), direction({dx}, {dy}, {dz}), centre({cx}, {cy}, {cz});
  glm::dvec3 p, q, normal;
  glm::dvec3 to = from + direction * 0x1p250;  // so far that it does not turn the line
  bool hit = glm::intersectLineSphere(from, to, centre, {r}, p, normal, q, normal);
  if (glm::dot(q - p, direction) < 0) p = q;
  hit ? std::printf("%.17g %.17g %.17g\n", p.x, p.y, p.z) : std::puts("miss");
}
