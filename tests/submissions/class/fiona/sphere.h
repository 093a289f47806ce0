#pragma once
#include <vector>
#include "math3.h"

struct sphere {
  vec3 center;
  double radius;
  vec3 ka, kd, ks, kr;

  bool intersect(const ray& r, double& s) const;
};

const sphere* nearest(const std::vector<sphere>& all, const ray& r, double& s);
