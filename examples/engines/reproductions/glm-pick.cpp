// g++ -std=c++17 case.cpp -o case
#define GLM_ENABLE_EXPERIMENTAL
#include <cstdio>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_projection.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtx/intersect.hpp>
using glm::dvec3;
int main() {
  const auto view = glm::lookAt(dvec3({ex}, {ey}, {ez}), dvec3({ax}, {ay}, {az}), dvec3({ux}, {uy}, {uz}));
  const auto projection = glm::frustum({left}, {right}, {bottom}, {top}, {near}, 1000 * {near});
  const glm::dvec4 window(0, 0, {width}, {height});
  const dvec3 from = glm::unProject(dvec3({i} + 0.5, {j} + 0.5, 0), view, projection, window);
  const dvec3 to = glm::unProject(dvec3({i} + 0.5, {j} + 0.5, 1), view, projection, window);
  dvec3 p, normal;
  glm::intersectRaySphere(from, glm::normalize(to - from), dvec3({cx}, {cy}, {cz}), {r}, p, normal)
      ? std::printf("%.17g %.17g %.17g\n", p.x, p.y, p.z)
      : std::puts("miss");
}
