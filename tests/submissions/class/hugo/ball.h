#include "vector3.h"

class Ball {
 public:
  Ball(const double* numbers);
  // distance along the ray, negative if the ray misses
  double distance(const Vector3& start, const Vector3& dir) const;

  Vector3 middle;
  double radius;
  int ambient[3], diffuse[3], specular[3];  // 0..255
};
