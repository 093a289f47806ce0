#include <cmath>

#include "casting.h"

static double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool Sphere::intersect(const Ray& ray, double& t) const {
  const Vec to = {ray.origin.x - centre.x, ray.origin.y - centre.y, ray.origin.z - centre.z};
  const double a = dot(ray.direction, ray.direction), b = 2 * dot(ray.direction, to);
  const double d = b * b - 4 * a * (dot(to, to) - radius * radius);
  if (d < 0) return false;
  t = (-b - std::sqrt(d)) / (2 * a);
  if (t < 0) t = (-b + std::sqrt(d)) / (2 * a);
  return t >= 0;
}
