// Embree's rtcOccluded1 on a sphere point in a separate scene, in floats: tfar is -inf for a hit.
// Debian: libembree-dev; -lembree3 or -lembree4. Source: the Embree manual,
// RTC_GEOMETRY_TYPE_SPHERE_POINT and rtcOccluded1. The manual does not mention tangents. Directions
// have any length.

#include "embree.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  RTCRay query = query_of(ray);
  rtcOccluded1(kept_scene_of(sphere), &query);
  if (query.tfar != -std::numeric_limits<float>::infinity()) return std::nullopt;
  return Hit{};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision,
                   .returns = Returns::class_only)
