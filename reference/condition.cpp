#include "reference/condition.h"

#include <algorithm>
#include <limits>

namespace raycheck::reference {
namespace {

constexpr int kBits = 256;

Enclosure radius(const Enclosure& x) {
  Enclosure result = x;
  arb_get_rad_arb(result.ball(), x.ball());
  return result;
}

double condition(const Enclosure& widened) { return widened.relative_radius() / kConditionChange; }

double condition(const Enclosure3& widened) {
  const Enclosure size = norm(widened);
  if (size.certain_sign() != 1) return std::numeric_limits<double>::infinity();
  const Enclosure width = norm(Enclosure3{radius(widened.x), radius(widened.y), radius(widened.z)});
  return (width / size).upper() / kConditionChange;
}

EnclosedRay widened(const ExactRay& ray) { return ray.enclose(kBits, kConditionChange); }

}  // namespace

double condition_of_frame(const ExactCamera& camera) {
  const EnclosedFrame frame = camera.frame_within(kConditionChange, kBits);
  return std::max({condition(frame.U), condition(frame.V), condition(frame.W)});
}

double condition_of_pixel_point(const ExactRay& ray) {
  return condition(widened(ray).pixel_point());
}

double condition_of_direction(const ExactRay& ray) { return condition(widened(ray).direction()); }

double condition_of_parameter(const ExactRay& ray, const scene::Sphere& sphere,
                              const Intersection& intersection) {
  if (intersection.hit_class == HitClass::kTangent) return std::numeric_limits<double>::infinity();
  return condition(widened(ray).parameter(sphere, intersection));
}

double condition_of_point(const ExactRay& ray, const scene::Sphere& sphere,
                          const Intersection& intersection) {
  if (intersection.hit_class == HitClass::kTangent) return std::numeric_limits<double>::infinity();
  return condition(widened(ray).point(sphere, intersection));
}

}  // namespace raycheck::reference
