#include "sphere.h"

Vec Vec::operator+(const Vec& o) const { return {x + o.x, y + o.y, z + o.z}; }
Vec Vec::operator-(const Vec& o) const { return {x - o.x, y - o.y, z - o.z}; }
Vec Vec::scale(double k) const { return {k * x, k * y, k * z}; }
double Vec::dot(const Vec& o) const { return x * o.x + y * o.y + z * o.z; }
Vec Vec::cross(const Vec& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
Vec Vec::unit() const { return scale(1 / sqrt(dot(*this))); }

bool Sphere::hit(const Vec& from, const Vec& dir, double& s) const {
  Vec t = center - from;
  double v = t.dot(dir);
  double disc = radius * radius - (t.dot(t) - v * v);
  if (disc < 0) return false;
  s = v - sqrt(disc);
  if (s < 0) s = v + sqrt(disc);
  return s >= 0;
}
