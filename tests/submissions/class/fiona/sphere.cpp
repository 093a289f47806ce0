#include "sphere.h"

bool sphere::intersect(const ray& r, double& s) const {
  vec3 t = center - r.from;
  double v = dot(t, r.to);
  double csq = dot(t, t);
  double dsq = radius * radius - (csq - v * v);
  if (dsq < 0) return false;
  double d = std::sqrt(dsq);
  s = v - d;
  if (s < 0) s = v + d;
  return s >= 0;
}

const sphere* nearest(const std::vector<sphere>& all, const ray& r, double& s) {
  const sphere* found = nullptr;
  for (auto& one : all) {
    double t;
    if (!one.intersect(r, t)) continue;
    if (found && t >= s) continue;
    found = &one;
    s = t;
  }
  return found;
}
