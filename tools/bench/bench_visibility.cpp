// Primary rays of whole images: certified visibility, the same code without certificates, and
// Embree if it was found. Items are rays. Making the rays is included in all times; plans and scene
// builds are not, and are reported in ms by the counters `plan_ms` and `build_ms`. Before anything
// is timed, a sample of certified pixels, and all pixels of the small scenes, are compared with the
// exact ray.
//   --target=NAME    is taken by choose_target; all else is Google Benchmark's

#include <benchmark/benchmark.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "properties/cases/case_source.h"
#include "reference/visibility/visibility.h"
#include "scene/files/scene_file.h"
#include "tools/bench/bench_embree.h"
#include "tools/bench/bench_scenes.h"
#include "tools/run/threads.h"

namespace {

using namespace raycheck;
using reference::Visibility;
using tools::in_view;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Shipped {
  std::string name;
  scene::Scene scene;
};

/// The scenes in scene/examples/ that have a camera, with 1024 x 1024 pixels.
std::vector<Shipped> shipped() {
  std::vector<Shipped> result;
  for (const auto& entry : std::filesystem::directory_iterator(RAYCHECK_EXAMPLES)) {
    if (entry.path().extension() != ".toml") continue;
    scene::Scene scene = scene::load_scene(entry.path()).scene;
    if (!scene.camera) continue;
    scene.camera->width = scene.camera->height = 1024;
    result.push_back({entry.path().stem().string(), scene});
  }
  std::ranges::sort(result, {}, &Shipped::name);
  return result;
}

/// A scene of each source with severities and a camera, at some severities, with 128 x 128 pixels.
std::vector<Shipped> families() {
  constexpr std::int64_t kSide = 128;
  constexpr int kSeverities = 6;
  std::vector<Shipped> result;
  for (const properties::CaseSource& source : properties::case_sources()) {
    if (!source.has_camera || !source.severities) continue;
    for (const int severity :
         properties::some_severities(0, source.severities->highest, kSeverities)) {
      const properties::ChosenSource chosen{&source, severity};
      scene::Scene scene = chosen.make(1).scene;
      if (scene.spheres.empty()) continue;
      scene.camera->width = scene.camera->height = kSide;
      result.push_back({chosen.name(), scene});
    }
  }
  return result;
}

struct Frame {
  std::vector<std::int32_t> sphere;
  std::vector<double> parameter;

  explicit Frame(const scene::Camera& camera)
      : sphere(static_cast<std::size_t>(camera.width * camera.height)), parameter(sphere.size()) {}
  reference::SeenRows rows() { return {sphere, parameter, {}, {}, {}}; }
};

const properties::RunControl on_all_threads = {.threads = tbb::info::default_concurrency()};

/// A scene with its plan made and its exact answer checked.
struct Prepared {
  double plan_ms = 0, threaded_plan_ms = 0, build_ms = 0;
  std::optional<Visibility> visibility;
  Frame truth;
  std::string wrong;

  explicit Prepared(scene::Scene its_scene) : truth(*its_scene.camera) {
    const auto start = seconds_now();
    auto plan = scene::plan_scene(its_scene, its_scene.conventions, scene::Wanted::kNearest);
    const auto planned = seconds_now();
    visibility.emplace(std::move(its_scene), std::move(plan));
    build_ms = 1e3 * (seconds_now() - planned);
    plan_ms = 1e3 * (planned - start);
    const auto built = seconds_now();
    scene::plan_scene(scene(), scene().conventions, scene::Wanted::kNearest, {},
                      tools::for_each_on(on_all_threads));
    threaded_plan_ms = 1e3 * (seconds_now() - built);
    visibility->nearest(0, scene().camera->height, truth.rows());
    check();
  }

  const scene::Scene& scene() const { return visibility->scene(); }

  /// Compares pixels with the exact ray, which tests every sphere; a budget of pairs limits their
  /// number.
  void check() {
    const scene::Camera& camera = *scene().camera;
    const std::size_t pixels = truth.sphere.size();
    const std::size_t budget = 2'000'000 / std::max<std::size_t>(1, scene().spheres.size()) + 2;
    const std::size_t step = std::max<std::size_t>(1, pixels / std::min(budget, pixels));
    const reference::ExactCamera exact(camera, scene().conventions);
    for (std::size_t at = 0; at < pixels; at += step) {
      const auto index = static_cast<std::int64_t>(at);
      const reference::ExactRay ray(exact, {index % camera.width, index / camera.width});
      const auto nearest = ray.nearest(scene().spheres, scene().conventions);
      const auto expected = nearest ? static_cast<std::int32_t>(nearest->index) : -1;
      if (truth.sphere[at] != expected) wrong = "pixel " + std::to_string(at) + " is wrong";
    }
  }
};

enum class By { kCertified, kUncertified, kEmbree };

/// Fills a frame; returns how it was decided.
using FillFrame = std::function<reference::DecidedBy(Frame&)>;

FillFrame fill_by(By by, const Prepared& prepared) {
  const Visibility& seen = *prepared.visibility;
  const std::int64_t height = prepared.scene().camera->height;
  if (by == By::kCertified) {
    return [&seen, height](Frame& frame) { return seen.nearest(0, height, frame.rows()); };
  }
#ifdef RAYCHECK_HAS_EMBREE
  if (by == By::kEmbree) {
    const auto embree = std::make_shared<tools::EmbreeImage>(prepared.scene());
    return [embree](Frame& frame) {
      embree->nearest(frame.sphere);
      return reference::DecidedBy();
    };
  }
#endif
  return [&seen, height](Frame& frame) {
    seen.nearest_uncertified(0, height, frame.rows());
    return reference::DecidedBy();
  };
}

void visibility(benchmark::State& state, By by, const Prepared& prepared) {
  if (!prepared.wrong.empty()) {
    state.SkipWithError(prepared.wrong.c_str());
    return;
  }
  Frame frame(*prepared.scene().camera);
  const FillFrame fill = fill_by(by, prepared);
  reference::DecidedBy decided_by;
  for (auto _ : state) {
    decided_by = fill(frame);
    benchmark::DoNotOptimize(frame.sphere.data());
    benchmark::ClobberMemory();
  }
  const auto pixels = static_cast<std::int64_t>(frame.sphere.size());
  state.SetItemsProcessed(state.iterations() * pixels);
  state.counters["spheres"] = static_cast<double>(prepared.scene().spheres.size());
  state.counters["plan_ms"] = prepared.plan_ms;
  state.counters["threaded_plan_ms"] = prepared.threaded_plan_ms;
  state.counters["build_ms"] = prepared.build_ms;
  state.counters["fallback"] = static_cast<double>(decided_by.fallback());
  std::int64_t hits = 0, wrong = 0;
  for (std::size_t k = 0; k < frame.sphere.size(); ++k) {
    hits += prepared.truth.sphere[k] >= 0 ? 1 : 0;
    wrong += frame.sphere[k] != prepared.truth.sphere[k] ? 1 : 0;
  }
  state.counters["seen"] = static_cast<double>(hits) / static_cast<double>(pixels);
  state.counters["wrong"] = static_cast<double>(wrong);
}

/// The scene is planned and checked once, and only if it is timed.
void register_scene(const std::string& name, const scene::Scene& scene) {
  const auto prepared = std::make_shared<std::optional<const Prepared>>();
  for (const auto& [by, what] : {std::pair(By::kCertified, "/certified"),
                                 {By::kUncertified, "/uncertified"}
#ifdef RAYCHECK_HAS_EMBREE
                                 ,
                                 {By::kEmbree, "/embree"}
#endif
       }) {
#ifdef RAYCHECK_HAS_EMBREE
    if (by == By::kEmbree && !tools::EmbreeImage::has(scene)) continue;
#endif
    benchmark::RegisterBenchmark((name + what).c_str(), [=, by = by](benchmark::State& state) {
      if (!*prepared) prepared->emplace(scene);
      visibility(state, by, **prepared);
    })->UseRealTime();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (!tools::choose_target(argc, argv)) return 2;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const std::int64_t spheres : {1, 10, 100, 1000, 10'000, 100'000, 1'000'000}) {
    register_scene("spheres:" + std::to_string(spheres), in_view(spheres));
  }
  for (const auto& [name, scene] : tools::hard_scenes()) register_scene("hard:" + name, scene);
  for (const auto& [name, scene] : families()) register_scene("family:" + name, scene);
  for (const auto& [name, scene] : shipped()) register_scene("shipped:" + name, scene);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
