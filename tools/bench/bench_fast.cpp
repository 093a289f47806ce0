// Nanoseconds per ray of the fast methods: rays of a camera, intersections of those, and of
// unrelated rays, a third of which miss. The baselines within the run are `lecture` (rays),
// `quadratic` and, for what exactness costs, `cross2` (intersections). A method is timed only after
// its answers kept the laws of class, root and direction, and its own bound on the parameter where
// it says that it keeps it. Where VecGeom was built in, its SIMD kernel is timed too, on the
// unrelated rays made unit: s alone, without points, of origins outside.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/trial.h"
#include "tools/bench/bench_scenes.h"
#include "tools/bench/bench_target.h"
#ifdef RAYCHECK_HAS_VECGEOM_SIMD
#include "tools/peers/vecgeom_simd.h"
#endif

namespace {

using namespace raycheck;
using tools::rays_of;
using tools::scene_in_view;
using tools::unrelated_rays;
using tools::wrong_answers;

void intersect(benchmark::State& state, const fast::IntersectMethod& method,
               const scene::Scene& scene) {
  if (const auto reason = wrong_answers(fast::kDirectRays, method, scene); !reason.empty()) {
    state.SkipWithError(reason.c_str());
    return;
  }
  const fast::Rays rays = rays_of(scene);
  const scene::Sphere sphere = scene.spheres.front();
  fast::Hits hits;
  for (auto _ : state) {
    method.intersect(rays, sphere, scene::Root::kNearest, scene::Tangent::kHit, hits);
    benchmark::DoNotOptimize(hits.parameter.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
  const auto met = std::count(hits.hit.begin(), hits.hit.end(), std::uint8_t{1});
  state.counters["hits"] = static_cast<double>(met) / static_cast<double>(rays.size());
}

void make_rays(benchmark::State& state, const fast::PixelRayMethod& method) {
  if (const auto reason = wrong_answers(method, fast::kCross, scene_in_view()); !reason.empty()) {
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

#ifdef RAYCHECK_HAS_VECGEOM_SIMD
constexpr double kVecgeomShare = 1e-9;  ///< How far its s may be from robust's.

void intersect_by_vecgeom(benchmark::State& state, const scene::Scene& scene) {
  fast::Rays rays = rays_of(scene);
  auto& [x, y, z] = rays.direction;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const double length = std::hypot(x[k], y[k], z[k]);
    x[k] /= length;
    y[k] /= length;
    z[k] /= length;
  }
  const scene::Sphere sphere = scene.spheres.front();
  fast::Hits expected;
  fast::kRobust.intersect(rays, sphere, scene::Root::kNearest, scene::Tangent::kHit, expected);
  std::vector<double> s(rays.size());
  peers::distances_by_vecgeom(rays, sphere, s);
  for (std::size_t k = 0; k < s.size(); ++k) {
    const bool right = expected.hit[k] == 0 ? s[k] >= std::numeric_limits<double>::max()
                                            : std::abs(s[k] - expected.parameter[k]) <=
                                                  kVecgeomShare * expected.parameter[k];
    if (!right) {
      state.SkipWithError("it is wrong about a ray");
      return;
    }
  }
  for (auto _ : state) {
    peers::distances_by_vecgeom(rays, sphere, s);
    benchmark::DoNotOptimize(s.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}
#endif

}  // namespace

int main(int argc, char** argv) {
  if (!tools::choose_target(argc, argv)) return 2;
  for (const auto* method : fast::pixel_ray_methods()) {
    benchmark::RegisterBenchmark(("rays/" + std::string(method->name)).c_str(),
                                 [method](benchmark::State& state) { make_rays(state, *method); });
  }
  for (const auto& [family, scene] :
       {std::pair("intersect/", scene_in_view()), std::pair("unrelated/", unrelated_rays())}) {
    for (const auto* method : fast::intersect_methods()) {
      benchmark::RegisterBenchmark(
          (family + std::string(method->name)).c_str(),
          [method, scene](benchmark::State& state) { intersect(state, *method, scene); });
    }
  }
#ifdef RAYCHECK_HAS_VECGEOM_SIMD
  benchmark::RegisterBenchmark("unrelated/vecgeom-simd", [](benchmark::State& state) {
    intersect_by_vecgeom(state, unrelated_rays());
  });
#endif
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
