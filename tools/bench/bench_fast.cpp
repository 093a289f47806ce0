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
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidates/fast_candidate.h"
#include "properties/cases/random.h"
#include "properties/laws/law.h"
#include "tools/bench/bench_target.h"
#ifdef RAYCHECK_HAS_VECGEOM_SIMD
#include "tools/peers/vecgeom_simd.h"
#endif

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

/// Rays from anywhere, as good as unrelated, aimed about a sphere so that a third miss it.
scene::Scene unrelated_rays() {
  // Not a multiple of 512: loads of one array would wait for stores to another, whose addresses
  // are the same modulo 4096.
  constexpr int kRays = 4000;
  scene::Scene scene;
  scene.spheres = {{{0.1, 0.3, 0.2}, 2.5}};
  const scene::Sphere& sphere = scene.spheres.front();
  properties::Random random(1);
  const auto around_sphere = [&](double distance) {
    const scene::Vector3 v = random.direction();
    const scene::Point3& c = sphere.centre;
    return scene::Point3{c.x + distance * v.x, c.y + distance * v.y, c.z + distance * v.z};
  };
  for (int k = 0; k < kRays; ++k) {
    const double distance = sphere.radius * random.between(1.5, 5);
    const double off = sphere.radius * random.between(0, 2.2);
    const scene::Point3 origin = around_sphere(distance);
    const scene::Point3 target = around_sphere(off);
    scene.rays.push_back({origin, target - origin});
  }
  return scene;
}

/// Why the pair must not be timed; empty when its answers are right.
std::string wrong_answers(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect,
                          const scene::Scene& scene) {
  properties::Case the_case{scene, {}};
  if (scene.camera) the_case.pixels = properties::all_pixels(*scene.camera);
  const properties::Candidate candidate = properties::fast_candidate(rays, intersect);
  properties::Trial trial(the_case, candidate);
  for (const properties::Law& law : properties::laws()) {
    if (!law.judges_values || !law.tells_stability) continue;
    // Among many rays some graze: there the less stable methods keep no bound.
    if (law.quantity == properties::Quantity::kParameter && !intersect.not_kept.empty()) continue;
    if (!apply(law, trial).holds()) {
      return candidate.name + " breaks the law " + std::string(law.name);
    }
  }
  return {};
}

fast::Rays rays_of(const scene::Scene& scene) {
  fast::Rays rays;
  if (scene.camera) {
    fast::kDirectRays.pixel_rays(*scene.camera, scene.conventions,
                                 properties::all_pixels(*scene.camera), rays);
    return rays;
  }
  rays.resize(scene.rays.size());
  for (std::size_t k = 0; k < scene.rays.size(); ++k) {
    const auto& [origin, direction] = scene.rays[k];
    rays.origin.x[k] = origin.x;
    rays.origin.y[k] = origin.y;
    rays.origin.z[k] = origin.z;
    rays.direction.x[k] = direction.x;
    rays.direction.y[k] = direction.y;
    rays.direction.z[k] = direction.z;
  }
  return rays;
}

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
