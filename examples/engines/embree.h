// Embree scenes of one sphere, kept from call to call.

#ifndef ENGINES_EMBREE_H_
#define ENGINES_EMBREE_H_

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <limits>
#include <stdexcept>

#define SINGLE
#include "adapter.h"

inline RTCDevice device() {
  static const RTCDevice made = rtcNewDevice("threads=1");
  if (made == nullptr) throw std::runtime_error("Embree refuses to start");
  return made;
}

/// In robust mode, bounding boxes lose no hit.
inline RTCScene scene_of(const raycheck::Sphere& sphere) {
  const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* const vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
  vertex[0] = static_cast<float>(sphere.centre.x);
  vertex[1] = static_cast<float>(sphere.centre.y);
  vertex[2] = static_cast<float>(sphere.centre.z);
  vertex[3] = static_cast<float>(sphere.radius);
  rtcCommitGeometry(geometry);
  const RTCScene scene = rtcNewScene(device());
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

/// The scene of the last sphere. Successive calls with the same sphere use the same scene.
inline RTCScene kept_scene_of(const raycheck::Sphere& sphere) {
  static raycheck::Sphere last;
  static RTCScene scene = nullptr;
  const auto& [c, r] = sphere;
  if (scene && c.x == last.centre.x && c.y == last.centre.y && c.z == last.centre.z &&
      r == last.radius) {
    return scene;
  }
  if (scene) rtcReleaseScene(scene);
  last = sphere;
  return scene = scene_of(sphere);
}

inline RTCRay query_of(const raycheck::Ray& ray) {
  const auto& [o, d] = ray;
  RTCRay query = {};
  query.org_x = static_cast<float>(o.x);
  query.org_y = static_cast<float>(o.y);
  query.org_z = static_cast<float>(o.z);
  query.dir_x = static_cast<float>(d.x);
  query.dir_y = static_cast<float>(d.y);
  query.dir_z = static_cast<float>(d.z);
  query.tfar = std::numeric_limits<float>::infinity();
  query.mask = ~0u;
  return query;
}

#if RTC_VERSION_MAJOR < 4
struct Context : RTCIntersectContext {
  Context() { rtcInitIntersectContext(this); }
};
inline void rtcIntersect1(RTCScene scene, RTCRayHit* query) {
  Context context;
  rtcIntersect1(scene, &context, query);
}
inline void rtcOccluded1(RTCScene scene, RTCRay* query) {
  Context context;
  rtcOccluded1(scene, &context, query);
}
#endif

#endif  // ENGINES_EMBREE_H_
