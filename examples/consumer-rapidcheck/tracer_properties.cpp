// Properties of your code, tested with hard rays and spheres.

#include <raycheck/exact.h>
#include <raycheck/rapidcheck.h>

#include "tracer.h"

int main() {
  bool holds = rc::check("a hit is within 64 ulps, where the sphere is near", [] {
    const raycheck::RaySphere pair = *raycheck::gen::ray_and_sphere("distance", 2);
    const auto exact = raycheck::exact::hit(pair.ray, pair.sphere);
    const auto hit = intersect(pair.ray, pair.sphere, {});
    RC_PRE(exact.is_hit && hit);
    RC_ASSERT(exact.parameter->ulp_error(hit->parameter) <= 64 * exact.parameter->condition());
  });
  holds &= rc::check("turning the ray round exchanges ahead and behind", [] {
    raycheck::RaySphere pair = *raycheck::gen::near_tangent(20);
    const bool ahead = raycheck::exact::hit(pair.ray, pair.sphere).is_hit;
    pair.ray.direction = -1 * pair.ray.direction;
    RC_ASSERT(!(ahead && raycheck::exact::hit(pair.ray, pair.sphere).is_hit) ||
              dot(pair.sphere.centre - pair.ray.origin, pair.sphere.centre - pair.ray.origin) <=
                  pair.sphere.radius * pair.sphere.radius * (1 + 1e-9));
  });
  return holds ? 0 : 1;
}
