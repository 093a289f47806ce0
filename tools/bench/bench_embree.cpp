#include "tools/bench/bench_embree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "fast/camera_frame.h"

namespace raycheck::tools {
namespace {

constexpr std::int64_t kRays = 8;

/// The positions of columns or rows under the conventions, padded to whole packets.
std::vector<float> positions(double low, double high, std::int64_t count, scene::Samples samples,
                             bool is_reversed) {
  std::vector<float> result;
  for (std::int64_t k = 0; k < count; ++k) {
    const scene::PixelSteps pixels = scene::pixel_steps(samples, count);
    const auto from_start = static_cast<double>(k);
    const double index = is_reversed ? pixels.turned() - from_start : from_start;
    const double share = (index + pixels.offset) / pixels.steps;
    result.push_back(static_cast<float>(low + share * (high - low)));
  }
  while (result.size() % kRays != 0) result.push_back(result.back());
  return result;
}

}  // namespace

struct EmbreeImage::Impl {
  scene::Scene scene;
  std::array<std::array<float, 3>, 3> axes;  ///< U, V, n W
  std::vector<float> alpha, beta;
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene embree = rtcNewScene(device);
};

bool EmbreeImage::has(const scene::Scene& scene) {
  constexpr double kMost = 1e18;
  const auto is_small = [](double x) { return std::abs(x) < kMost; };
  const auto is_near = [&](const scene::Point3& p) {
    return is_small(p.x) && is_small(p.y) && is_small(p.z);
  };
  const scene::Camera& camera = *scene.camera;
  return is_near(camera.eye) && is_small(camera.near) && std::abs(camera.near) > 1 / kMost &&
         is_small(camera.left) && is_small(camera.right) && is_small(camera.bottom) &&
         is_small(camera.top) &&
         std::ranges::all_of(scene.spheres, [&](const scene::Sphere& sphere) {
           return is_near(sphere.centre) && is_small(sphere.radius);
         });
}

EmbreeImage::EmbreeImage(const scene::Scene& scene) {
  auto impl = std::make_unique<Impl>();
  impl->scene = scene;
  const scene::Camera& camera = *scene.camera;
  const auto [U, V, W] = fast::camera_frame(camera);
  const auto floats = [](const auto& v, double by) {
    return std::array{static_cast<float>(by * v.x), static_cast<float>(by * v.y),
                      static_cast<float>(by * v.z)};
  };
  impl->axes = {floats(U, 1), floats(V, 1), floats(W, camera.near)};
  impl->alpha =
      positions(camera.left, camera.right, camera.width, scene.conventions.samples, false);
  impl->beta = positions(camera.bottom, camera.top, camera.height, scene.conventions.samples,
                         scene.conventions.rows == scene::Rows::kTopFirst);
  const RTCGeometry spheres = rtcNewGeometry(impl->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* to = static_cast<float*>(rtcSetNewGeometryBuffer(spheres, RTC_BUFFER_TYPE_VERTEX, 0,
                                                         RTC_FORMAT_FLOAT4, 4 * sizeof(float),
                                                         scene.spheres.size()));
  for (const scene::Sphere& sphere : scene.spheres) {
    to = std::copy_n(floats(sphere.centre, 1).begin(), 3, to);
    *to++ = static_cast<float>(sphere.radius);
  }
  rtcCommitGeometry(spheres);
  rtcSetSceneFlags(impl->embree, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(impl->embree, spheres);
  rtcReleaseGeometry(spheres);
  rtcCommitScene(impl->embree);
  impl_ = std::move(impl);
}

EmbreeImage::~EmbreeImage() {
  rtcReleaseScene(impl_->embree);
  rtcReleaseDevice(impl_->device);
}

void EmbreeImage::nearest(std::span<std::int32_t> spheres) const {
  const auto& [scene, axes, alpha, beta, device, embree] = *impl_;
  const auto& [U, V, nW] = axes;
  const scene::Point3& E = scene.camera->eye;
  const std::array origin{static_cast<float>(E.x), static_cast<float>(E.y),
                          static_cast<float>(E.z)};
  const float start = scene.conventions.origin == scene::Origin::kPixel ? 1 : 0;
  const std::int64_t width = scene.camera->width;
  alignas(32) const std::array<int, kRays> all = {-1, -1, -1, -1, -1, -1, -1, -1};
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (std::int64_t j = 0; j < scene.camera->height; ++j) {
    const float y = beta[static_cast<std::size_t>(j)];
    for (std::int64_t i = 0; i < width; i += kRays) {
      RTCRayHit8 packet;
      for (std::size_t k = 0; k < kRays; ++k) {
        const float x = alpha[static_cast<std::size_t>(i) + k];
        packet.ray.org_x[k] = origin[0];
        packet.ray.org_y[k] = origin[1];
        packet.ray.org_z[k] = origin[2];
        packet.ray.dir_x[k] = nW[0] + x * U[0] + y * V[0];
        packet.ray.dir_y[k] = nW[1] + x * U[1] + y * V[1];
        packet.ray.dir_z[k] = nW[2] + x * U[2] + y * V[2];
        packet.ray.tnear[k] = start;
        packet.ray.tfar[k] = std::numeric_limits<float>::infinity();
        packet.ray.time[k] = 0;
        packet.ray.mask[k] = ~0U;
        packet.ray.flags[k] = 0;
        packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect8(all.data(), embree, &context, &packet);
      const std::int64_t count = std::min(kRays, width - i);
      for (std::int64_t k = 0; k < count; ++k) {
        const bool is_hit = packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        spheres[static_cast<std::size_t>(j * width + i + k)] =
            is_hit ? static_cast<std::int32_t>(packet.hit.primID[k]) : -1;
      }
    }
  }
}

}  // namespace raycheck::tools
