// Embree's rtcIntersect1 on a sphere point in a separate scene, in floats: tfar is the parameter of
// the hit. Debian: libembree-dev; -lembree3 or -lembree4. Source: the Embree manual,
// RTC_GEOMETRY_TYPE_SPHERE_POINT and rtcIntersect1. Silent on tangents; directions of any length.

#include "embree.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  RTCRayHit query = {query_of(ray), {}};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(kept_scene_of(sphere), &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Hit{query.ray.tfar, {}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision,
                   .returns = Returns::parameter)
