#pragma once

#include "scene/geometry.h"

namespace raycheck::peers {

/// a t^2 + b t + c
struct Quadratic {
  double a, b, c;
};

/// |L + t D - C|^2 = r^2 as textbooks print it, every operation rounded.
inline Quadratic textbook(const scene::Ray& ray, const scene::Sphere& sphere) {
  const scene::Vector3& D = ray.direction;
  const scene::Vector3 f = ray.origin - sphere.centre;
  return {D.x * D.x + D.y * D.y + D.z * D.z, 2 * (f.x * D.x + f.y * D.y + f.z * D.z),
          f.x * f.x + f.y * f.y + f.z * f.z - sphere.radius * sphere.radius};
}

}  // namespace raycheck::peers
