#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "fast/ray_by_ray.h"
#include "tools/peers/peers.h"

namespace raycheck::peers {
namespace {

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

template <class Handle>
Owned<Handle> made(Handle handle) {
  if (handle == nullptr) throw std::runtime_error("Embree refuses to start");
  return Owned<Handle>(handle);
}

RTCDevice device() {
  static const Owned<RTCDevice> kDevice = made(rtcNewDevice("threads=1"));
  return kDevice.get();
}

/// A scene of one sphere; robust: its boxes lose no hit of the sphere inside.
Owned<RTCScene> scene_of(const scene::Sphere& sphere) {
  const auto geometry = made(rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_SPHERE_POINT));
  auto* const vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
  if (vertex == nullptr) throw std::runtime_error("Embree refuses a sphere");
  vertex[0] = static_cast<float>(sphere.centre.x);
  vertex[1] = static_cast<float>(sphere.centre.y);
  vertex[2] = static_cast<float>(sphere.centre.z);
  vertex[3] = static_cast<float>(sphere.radius);
  rtcCommitGeometry(geometry.get());
  auto scene = made(rtcNewScene(device()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene.get(), geometry.get());
  rtcCommitScene(scene.get());
  return scene;
}

/// The scene of the last sphere, kept so that a batch, or calls about one sphere, build it once.
RTCScene kept_scene_of(const scene::Sphere& sphere) {
  struct Kept {
    scene::Sphere sphere;
    Owned<RTCScene> scene;
  };
  thread_local Kept kept;
  if (kept.scene == nullptr || !(kept.sphere == sphere)) kept = {sphere, scene_of(sphere)};
  return kept.scene.get();
}

/// Beyond this Embree leaves spheres out of its scenes, and may abort when asked about a ray.
constexpr double kEmbreeLargest = 1e18;

bool is_within_embree(const scene::Ray& ray) {
  for (const double x : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y,
                         ray.direction.z}) {
    if (!(std::abs(x) <= kEmbreeLargest)) return false;
  }
  return true;
}

struct Embree {
  explicit Embree(const scene::Sphere& sphere) : scene(kept_scene_of(sphere)) {}

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::Root /*root*/,
                                  scene::Tangent /*tangent*/) const {
    if (!is_within_embree(ray)) return std::nullopt;
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
    // Packets (rtcIntersect8) take other paths where few rays are left in them: a batch would
    // answer differently from a single call.
    rtcIntersect1(scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return fast::hit_at(ray, static_cast<double>(query.ray.tfar));
  }

  RTCScene scene;
};

/// Squares of radii, over squares of directions, stay in the normal range of single precision.
constexpr fast::Domain kSingleDomain = {.smallest_length = 0x1p-30, .largest_length = 0x1p30};

/// In the ulp and u of double precision, of arithmetic that has 29 bits less.
constexpr double kMaxUlp = 96 * 0x1p29;

}  // namespace

extern const fast::IntersectMethod kEmbree = {
    .name = "embree",
    .sentence = "rtcIntersect1 on a sphere in a scene of its own; inputs and s in single precision",
    .intersect = fast::intersect_ray_by_ray<Embree>,
    .intersect_one = fast::intersect_one_ray<Embree>,
    .max_ulp = kMaxUlp,
    .max_point_ulp = kMaxUlp,
    .not_kept = "far spheres, grazing rays; beyond 1e18 everything is a miss",
    .domain = kSingleDomain,
    .contract = {.root = scene::Root::kNearest, .tangent = scene::Tangent::kHit},
    .unit_roundoff = 0x1p-24,
};

}  // namespace raycheck::peers
