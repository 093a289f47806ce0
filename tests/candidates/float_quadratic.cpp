// The quadratic formula in float, as textbooks print it: b^2 - 4ac cancels, and so does -b - root.

#include <cmath>
#include <raycheck/candidate.hpp>

using namespace raycheck;

namespace {

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  const float d[] = {float(ray.direction.x), float(ray.direction.y), float(ray.direction.z)};
  const float f[] = {float(ray.origin.x) - float(sphere.centre.x),
                     float(ray.origin.y) - float(sphere.centre.y),
                     float(ray.origin.z) - float(sphere.centre.z)};
  const float r = float(sphere.radius);
  const float a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  const float b = 2 * (f[0] * d[0] + f[1] * d[1] + f[2] * d[2]);
  const float c = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] - r * r;
  const float discriminant = b * b - 4 * a * c;
  if (discriminant < 0 || (discriminant == 0 && asked.tangent == Tangent::miss)) return {};
  const float root = std::sqrt(discriminant);
  float s = (-b - root) / (2 * a);
  if (s < 0 && asked.root == Root::nearest) s = (-b + root) / (2 * a);
  if (s < 0) return {};
  return Hit{s,
             {float(ray.origin.x) + s * d[0], float(ray.origin.y) + s * d[1],
              float(ray.origin.z) + s * d[2]}};
}

}  // namespace

RAYCHECK_CANDIDATE(.intersect = intersect, .precision = Precision::single)
