#include "ball.h"
#include <cmath>

Ball::Ball(const double* n) {
  middle = make(n[0], n[1], n[2]);
  radius = n[3];
  for (int k = 0; k < 3; k++) {
    ambient[k] = (int)(255 * n[4 + k]);
    diffuse[k] = (int)(255 * n[7 + k]);
    specular[k] = (int)(255 * n[10 + k]);
  }
}

double Ball::distance(const Vector3& start, const Vector3& dir) const {
  Vector3 t = plus(middle, start, -1);
  double v = dot(t, dir);
  Vector3 foot = plus(t, dir, -v);
  double inside = radius * radius - dot(foot, foot);
  if (inside < 0) return -1;
  double d = std::sqrt(inside);
  if (v - d >= 0) return v - d;
  return v + d;
}
