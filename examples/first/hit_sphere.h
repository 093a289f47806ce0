// The first intersection of a ray and a sphere by the textbook formula. b^2 - 4ac cancels for far
// spheres.

#pragma once

#include <cmath>

/// The smallest s >= 0 with |o + s d - c| = r, or -1.
template <typename Vector>
double hit_sphere(const Vector& o, const Vector& d, const Vector& c, double r) {
  const Vector f{o.x - c.x, o.y - c.y, o.z - c.z};
  const double a = d.x * d.x + d.y * d.y + d.z * d.z;
  const double b = 2 * (f.x * d.x + f.y * d.y + f.z * d.z);
  const double discriminant = b * b - 4 * a * (f.x * f.x + f.y * f.y + f.z * f.z - r * r);
  if (discriminant < 0) return -1;
  const double root = std::sqrt(discriminant);
  const double near = (-b - root) / (2 * a), far = (-b + root) / (2 * a);
  return near >= 0 ? near : far >= 0 ? far : -1;
}

/// o + s d.
template <typename Vector>
Vector along(const Vector& o, double s, const Vector& d) {
  return {o.x + s * d.x, o.y + s * d.y, o.z + s * d.z};
}
