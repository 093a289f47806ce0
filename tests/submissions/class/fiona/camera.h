#pragma once
#include "math3.h"

class camera {
 public:
  vec3 eye, look, up;
  double d, left, bottom, right, top;
  int width, height;

  ray shoot(int i, int j) const;
};
