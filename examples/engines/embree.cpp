// Embree's rtcIntersect1 on a sphere in a scene of its own, in single precision. Debian:
// libembree-dev; -lembree3.
//
// Source: the Embree 3 manual, RTC_GEOMETRY_TYPE_SPHERE and rtcIntersect1.

#include <embree3/rtcore.h>

#include <limits>
#include <stdexcept>

#include "adapter.h"

using namespace raycheck;

namespace {

RTCDevice device() {
  static const RTCDevice made = rtcNewDevice("threads=1");
  if (made == nullptr) throw std::runtime_error("Embree refuses to start");
  return made;
}

/// A scene of one sphere. Robust mode: its bounding boxes lose no hit.
RTCScene scene_of(const Sphere& sphere) {
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

/// That of the last sphere, so that calls about one sphere build it once.
RTCScene kept_scene_of(const Sphere& sphere) {
  static Sphere last;
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

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query = {};
  query.ray.org_x = static_cast<float>(ray.origin.x);
  query.ray.org_y = static_cast<float>(ray.origin.y);
  query.ray.org_z = static_cast<float>(ray.origin.z);
  query.ray.dir_x = static_cast<float>(ray.direction.x);
  query.ray.dir_y = static_cast<float>(ray.direction.y);
  query.ray.dir_z = static_cast<float>(ray.direction.z);
  query.ray.tnear = 0;
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(kept_scene_of(sphere), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  // Embree returns no point: its users compute one like this, in floats.
  const float s = query.ray.tfar;
  return Hit{s,
             {query.ray.org_x + s * query.ray.dir_x, query.ray.org_y + s * query.ray.dir_y,
              query.ray.org_z + s * query.ray.dir_z}};
}

}  // namespace

// Tangents count as hits and the first root >= 0 is taken, whatever the conventions say. The
// squares of lengths stay in the range of floats.
RAYCHECK_CANDIDATE(.name = "embree", .root = Root::nearest, .tangent = Tangent::hit,
                   .intersect = intersect, .level = Level::ordinary, .smallest_length = 0x1p-30,
                   .largest_length = 0x1p30, .precision = Precision::single)
