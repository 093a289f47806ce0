// Nanoseconds per ray of the fast methods, as ratios to `quadratic` (intersections) and `lecture`
// (rays) within the run. A method is timed only after its answers passed the class law and its
// bound.

#include <benchmark/benchmark.h>

#include <optional>
#include <string>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/fast_candidate.h"
#include "properties/law.h"

namespace {

using namespace raycheck;

scene::Scene scene_in_view() {
  scene::Scene scene;
  scene.camera = scene::Camera{{1.3, 2.7, 9.1},
                               {0.2, 0.1, -3},
                               {0.1, 1, 0.3},
                               -1,
                               std::nullopt,
                               -0.8,
                               0.8,
                               -0.8,
                               0.8,
                               64,
                               64};
  scene.spheres = {{{0.1, 0.3, 0.2}, 2.5}};
  return scene;
}

/// Why the pair must not be timed; empty when its answers are right.
std::string wrong_answers(const fast::PixelRayMethod& rays,
                          const fast::IntersectMethod& intersect) {
  const properties::Case the_case{scene_in_view(), properties::all_pixels(*scene_in_view().camera)};
  const properties::Candidate candidate = properties::fast_candidate(rays, intersect);
  properties::Trial trial(the_case, candidate);
  for (const char* name : {"class", "nearest-root", "direction"}) {
    const properties::Verdict verdict = apply(*properties::find_law(name), trial);
    if (!verdict.holds()) return candidate.name + " breaks the law " + name;
  }
  return {};
}

fast::Rays rays_in_view() {
  const scene::Scene scene = scene_in_view();
  fast::Rays rays;
  fast::kDirectRays.pixel_rays(*scene.camera, scene.conventions,
                               properties::all_pixels(*scene.camera), rays);
  return rays;
}

void intersect(benchmark::State& state, const fast::IntersectMethod& method) {
  if (const auto reason = wrong_answers(fast::kDirectRays, method); !reason.empty()) {
    state.SkipWithError(reason.c_str());
    return;
  }
  const fast::Rays rays = rays_in_view();
  const scene::Sphere sphere = scene_in_view().spheres.front();
  fast::Hits hits;
  for (auto _ : state) {
    method.intersect(rays, sphere, scene::Root::kNearest, scene::Tangent::kHit, hits);
    benchmark::DoNotOptimize(hits.parameter.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}

void make_rays(benchmark::State& state, const fast::PixelRayMethod& method) {
  if (const auto reason = wrong_answers(method, fast::kCross); !reason.empty()) {
    state.SkipWithError(reason.c_str());
    return;
  }
  const scene::Scene scene = scene_in_view();
  const auto pixels = properties::all_pixels(*scene.camera);
  const auto make = method.pixel_rays != nullptr ? method.pixel_rays : method.focal_rays;
  fast::Rays rays;
  for (auto _ : state) {
    make(*scene.camera, scene.conventions, pixels, rays);
    benchmark::DoNotOptimize(rays.direction.x.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pixels.size()));
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto* method : fast::pixel_ray_methods()) {
    benchmark::RegisterBenchmark(("rays/" + std::string(method->name)).c_str(),
                                 [method](benchmark::State& state) { make_rays(state, *method); });
  }
  for (const auto* method : fast::intersect_methods()) {
    benchmark::RegisterBenchmark(("intersect/" + std::string(method->name)).c_str(),
                                 [method](benchmark::State& state) { intersect(state, *method); });
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
