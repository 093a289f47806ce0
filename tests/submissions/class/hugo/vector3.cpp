#include "vector3.h"
#include <cmath>

Vector3 make(double x, double y, double z) {
  Vector3 v;
  v.e[0] = x;
  v.e[1] = y;
  v.e[2] = z;
  return v;
}

// a + times * b
Vector3 plus(const Vector3& a, const Vector3& b, double times) {
  return make(a.e[0] + times * b.e[0], a.e[1] + times * b.e[1], a.e[2] + times * b.e[2]);
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return make(a.e[1] * b.e[2] - a.e[2] * b.e[1], a.e[2] * b.e[0] - a.e[0] * b.e[2],
              a.e[0] * b.e[1] - a.e[1] * b.e[0]);
}

double dot(const Vector3& a, const Vector3& b) {
  double sum = 0;
  for (int k = 0; k < 3; k++) sum += a.e[k] * b.e[k];
  return sum;
}

Vector3 unit(const Vector3& a) {
  Vector3 zero = make(0, 0, 0);
  return plus(zero, a, 1 / std::sqrt(dot(a, a)));
}
