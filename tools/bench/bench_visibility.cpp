// Primary rays of whole images: certified visibility, the same code without certificates, and,
// where it was built in, Embree's rtcIntersect8. Items are rays; ray set-up is included everywhere,
// plans and scene builds are excluded and reported in ms as the counters `plan_ms` and `build_ms`.
// Before anything is timed, a sample of certified pixels, and all pixels of the small scenes, are
// compared with the exact ray.
//   --target=NAME    is taken by choose_target; all else is Google Benchmark's

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fast/camera_frame.h"
#include "reference/visibility/visibility.h"
#include "scene/files/scene_file.h"
#include "tools/bench/bench_scenes.h"
#include "tools/bench/bench_target.h"
#ifdef RAYCHECK_HAS_EMBREE
#include <embree3/rtcore.h>
#endif

namespace {

using namespace raycheck;
using reference::DecidedBy;
using reference::Visibility;
using tools::camera_of;
using tools::in_view;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Shipped {
  std::string name;
  scene::Scene scene;
};

/// The scenes of scene/examples/ that have a camera, in 1024 x 1024 pixels.
std::vector<Shipped> shipped() {
  std::vector<Shipped> result;
  for (const auto& entry : std::filesystem::directory_iterator(RAYCHECK_EXAMPLES)) {
    if (entry.path().extension() != ".toml") continue;
    scene::Scene scene = scene::load_scene(entry.path()).scene;
    if (!scene.camera) continue;
    scene.camera->width = scene.camera->height = 1024;
    result.push_back({entry.path().stem().string(), scene});
  }
  std::sort(result.begin(), result.end(),
            [](const Shipped& a, const Shipped& b) { return a.name < b.name; });
  return result;
}

/// A share of the pixels, by columns, looks exactly at a point (a sphere of radius 0): tangents
/// all, which no filter decides. The numbers are dyadic, so that the points are on the rays.
scene::Scene grazing(double share) {
  constexpr std::int64_t kSize = 128;
  scene::Scene scene;
  scene.camera = scene::Camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, -1,        std::nullopt, -1,
                               1,         -1,         1,         kSize + 1, kSize + 1};
  const auto columns = static_cast<std::int64_t>(share * (kSize + 1) + 0.5);
  for (std::int64_t i = 0; i < columns; ++i) {
    for (std::int64_t j = 0; j <= kSize; ++j) {
      const double x = -1 + static_cast<double>(i) / (kSize / 2);
      const double y = -1 + static_cast<double>(j) / (kSize / 2);
      scene.spheres.push_back({{8 * x, 8 * y, -8}, 0});
    }
  }
  return scene;
}

struct Frame {
  std::vector<std::int32_t> sphere;
  std::vector<double> parameter;

  explicit Frame(const scene::Camera& camera)
      : sphere(static_cast<std::size_t>(camera.width * camera.height)), parameter(sphere.size()) {}
  reference::SeenRows rows() { return {sphere, parameter, {}, {}, {}}; }
};

/// A scene, its plan made and its exact answer checked.
struct Prepared {
  scene::Scene scene;
  double plan_ms = 0, build_ms = 0;
  std::optional<Visibility> visibility;
  Frame truth;
  std::string wrong;

  explicit Prepared(const scene::Scene& its_scene) : scene(its_scene), truth(*scene.camera) {
    const auto start = seconds_now();
    auto plan = scene::plan_scene(scene, scene.conventions, scene::Wanted::kNearest);
    const auto planned = seconds_now();
    visibility.emplace(scene, std::move(plan));
    build_ms = 1e3 * (seconds_now() - planned);
    plan_ms = 1e3 * (planned - start);
    visibility->nearest(0, scene.camera->height, truth.rows());
    check();
  }

  /// Pixels compared with the exact ray, which asks every sphere: a budget of pairs.
  void check() {
    const scene::Camera& camera = *scene.camera;
    const std::size_t pixels = truth.sphere.size();
    const std::size_t budget = 2'000'000 / std::max<std::size_t>(1, scene.spheres.size()) + 2;
    const std::size_t step = std::max<std::size_t>(1, pixels / std::min(budget, pixels));
    const reference::ExactCamera exact(camera, scene.conventions);
    for (std::size_t at = 0; at < pixels; at += step) {
      const auto index = static_cast<std::int64_t>(at);
      const reference::ExactRay ray(exact, {index % camera.width, index / camera.width});
      const auto nearest = ray.nearest(scene.spheres, scene.conventions);
      const auto expected = nearest ? static_cast<std::int32_t>(nearest->index) : -1;
      if (truth.sphere[at] != expected) wrong = "pixel " + std::to_string(at) + " is wrong";
    }
  }
};

void report(benchmark::State& state, const Prepared& prepared, std::int64_t rays) {
  state.SetItemsProcessed(state.iterations() * rays);
  state.counters["spheres"] = static_cast<double>(prepared.scene.spheres.size());
  state.counters["plan_ms"] = prepared.plan_ms;
  state.counters["build_ms"] = prepared.build_ms;
}

enum class What { kCertified, kUncertified, kTwoThreads, kClassesOfAll };

void visibility(benchmark::State& state, What what,
                const std::shared_ptr<const Prepared>& prepared) {
  if (!prepared->wrong.empty()) {
    state.SkipWithError(prepared->wrong.c_str());
    return;
  }
  const Visibility& seen = *prepared->visibility;
  const std::int64_t height = prepared->scene.camera->height;
  const auto pixels = static_cast<std::int64_t>(prepared->truth.sphere.size());
  Frame frame(*prepared->scene.camera);
  std::vector<reference::HitClass> classes(frame.sphere.size());
  DecidedBy decided_by;
  for (auto _ : state) {
    switch (what) {
      case What::kCertified:
        decided_by = seen.nearest(0, height, frame.rows());
        break;
      case What::kUncertified:
        seen.nearest_uncertified(0, height, frame.rows());
        break;
      case What::kTwoThreads:
        decided_by = reference::nearest_in_parallel(seen, 0, height, frame.rows(), 2);
        break;
      case What::kClassesOfAll:
        for (std::size_t k = 0; k < prepared->scene.spheres.size(); ++k) {
          decided_by = seen.classes(k, 0, height, classes);
        }
    }
    benchmark::DoNotOptimize(frame.sphere.data());
    benchmark::DoNotOptimize(classes.data());
    benchmark::ClobberMemory();
  }
  const bool pairs = what == What::kClassesOfAll;
  report(state, *prepared,
         pairs ? pixels * static_cast<std::int64_t>(prepared->scene.spheres.size()) : pixels);
  state.counters["fallback"] = static_cast<double>(decided_by.fallback());
  std::int64_t hits = 0, wrong = 0;
  for (std::size_t k = 0; k < frame.sphere.size(); ++k) {
    hits += prepared->truth.sphere[k] >= 0 ? 1 : 0;
    wrong += !pairs && frame.sphere[k] != prepared->truth.sphere[k] ? 1 : 0;
  }
  state.counters["seen"] = static_cast<double>(hits) / static_cast<double>(pixels);
  state.counters["wrong"] = static_cast<double>(wrong);
}

/// What nothing in view is measured against.
void fill(benchmark::State& state) {
  Frame frame(*camera_of(1024, 1024).camera);
  for (auto _ : state) {
    std::fill(frame.sphere.begin(), frame.sphere.end(), reference::kNoSphere);
    std::fill(frame.parameter.begin(), frame.parameter.end(), reference::kNoParameter);
    benchmark::DoNotOptimize(frame.sphere.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * 1024 * 1024);
}

#ifdef RAYCHECK_HAS_EMBREE
/// Coherent packets of eight along rows; rays from the eye through the pixel point, in floats.
void embree(benchmark::State& state, const std::shared_ptr<const Prepared>& prepared) {
  const scene::Camera& camera = *prepared->scene.camera;
  const auto& spheres = prepared->scene.spheres;
  RTCDevice device = rtcNewDevice("threads=1");
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* const vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), spheres.size()));
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    vertex[4 * k] = static_cast<float>(spheres[k].centre.x);
    vertex[4 * k + 1] = static_cast<float>(spheres[k].centre.y);
    vertex[4 * k + 2] = static_cast<float>(spheres[k].centre.z);
    vertex[4 * k + 3] = static_cast<float>(spheres[k].radius);
  }
  const double start = seconds_now();
  rtcCommitGeometry(geometry);
  RTCScene scene = rtcNewScene(device);
  rtcAttachGeometry(scene, geometry);
  rtcCommitScene(scene);
  const double build_ms = 1e3 * (seconds_now() - start);
  const auto [U, V, W] = fast::camera_frame(camera);
  Frame frame(camera);
  std::vector<float> parameter(frame.sphere.size());
  const int valid[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
  const auto extent = static_cast<float>(camera.right - camera.left);
  const auto rise = static_cast<float>(camera.top - camera.bottom);
  for (auto _ : state) {
    for (std::int64_t j = 0; j < camera.height; ++j) {
      const float beta = static_cast<float>(camera.bottom) +
                         rise * static_cast<float>(j) / static_cast<float>(camera.height - 1);
      for (std::int64_t i = 0; i < camera.width; i += 8) {
        RTCRayHit8 packet;
        for (int lane = 0; lane < 8; ++lane) {
          const float alpha =
              static_cast<float>(camera.left) +
              extent * static_cast<float>(i + lane) / static_cast<float>(camera.width - 1);
          const auto n = static_cast<float>(camera.near);
          const auto g = [&](double u, double v, double w) {
            return n * static_cast<float>(w) + alpha * static_cast<float>(u) +
                   beta * static_cast<float>(v);
          };
          const float x = g(U.x, V.x, W.x), y = g(U.y, V.y, W.y), z = g(U.z, V.z, W.z);
          const float scale = 1 / std::sqrt(x * x + y * y + z * z);
          packet.ray.org_x[lane] = static_cast<float>(camera.eye.x) + x;
          packet.ray.org_y[lane] = static_cast<float>(camera.eye.y) + y;
          packet.ray.org_z[lane] = static_cast<float>(camera.eye.z) + z;
          packet.ray.dir_x[lane] = x * scale;
          packet.ray.dir_y[lane] = y * scale;
          packet.ray.dir_z[lane] = z * scale;
          packet.ray.tnear[lane] = 0;
          packet.ray.tfar[lane] = HUGE_VALF;
          packet.ray.time[lane] = 0;
          packet.ray.mask[lane] = ~0u;
          packet.ray.flags[lane] = 0;
          packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcIntersect8(valid, scene, &context, &packet);
        for (int lane = 0; lane < 8; ++lane) {
          const auto at = static_cast<std::size_t>(j * camera.width + i + lane);
          const bool hit = packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
          frame.sphere[at] = hit ? static_cast<std::int32_t>(packet.hit.primID[lane]) : -1;
          parameter[at] = packet.ray.tfar[lane];
        }
      }
    }
    benchmark::ClobberMemory();
  }
  report(state, *prepared, static_cast<std::int64_t>(frame.sphere.size()));
  state.counters["build_ms"] = build_ms;
  std::int64_t wrong = 0;
  for (std::size_t k = 0; k < frame.sphere.size(); ++k) {
    wrong += frame.sphere[k] != prepared->truth.sphere[k] ? 1 : 0;
  }
  state.counters["wrong"] = static_cast<double>(wrong);
  rtcReleaseScene(scene);
  rtcReleaseGeometry(geometry);
  rtcReleaseDevice(device);
}
#endif

void register_scene(const std::string& name, const scene::Scene& scene, bool with_peers) {
  const auto prepared = std::make_shared<const Prepared>(scene);
  const auto add = [&](const std::string& what, What kind) {
    benchmark::RegisterBenchmark((name + "/" + what).c_str(), [prepared, kind](auto& state) {
      visibility(state, kind, prepared);
    })->UseRealTime();
  };
  add("certified", What::kCertified);
  add("uncertified", What::kUncertified);
  add("two-threads", What::kTwoThreads);
  if (scene.spheres.size() <= 100) add("classes", What::kClassesOfAll);
#ifdef RAYCHECK_HAS_EMBREE
  if (with_peers) {
    benchmark::RegisterBenchmark((name + "/embree").c_str(),
                                 [prepared](auto& state) { embree(state, prepared); });
  }
#else
  (void)with_peers;
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (!tools::choose_target(argc, argv)) return 2;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RegisterBenchmark("fill", fill);
  register_scene("nothing", camera_of(1024, 1024), false);
  for (const std::int64_t spheres : {1, 10, 100, 1000, 10'000, 100'000, 1'000'000}) {
    register_scene("spheres:" + std::to_string(spheres), in_view(spheres), spheres <= 10'000);
  }
  for (const auto& [name, scene] : shipped()) {
    // What Embree is asked has the default conventions.
    register_scene("shipped:" + name, scene, scene.conventions == scene::Conventions{});
  }
  for (const std::int64_t size : {256, 512, 2048, 4096}) {
    register_scene("pixels:" + std::to_string(size), in_view(100, size), false);
  }
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    register_scene("grazing:" + std::to_string(static_cast<int>(100 * share)), grazing(share),
                   false);
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
