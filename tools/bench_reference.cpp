// How many exact answers per second. Every benchmark checks its answers against the exact field or
// a wider enclosure before it is timed.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "reference/exact_ray.h"

namespace {

using namespace raycheck;

constexpr int kSide = 512;

scene::Camera camera() {
  return {{1.3, 2.7, 9.1}, {0.2, 0.1, -3}, {0.1, 1, 0.3}, -1, std::nullopt, -0.8, 0.8, -0.8, 0.8,
          kSide,           kSide};
}
const scene::Sphere kSphere = {{0.1, 0.3, 0.2}, 2.5};

/// Pixels all over the image, in an order that no predictor learns.
std::vector<scene::Pixel> pixels() {
  std::vector<scene::Pixel> result;
  std::uint64_t state = 1;
  for (int k = 0; k < 1 << 14; ++k) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    result.push_back({static_cast<std::int64_t>((state >> 33) % kSide),
                      static_cast<std::int64_t>((state >> 45) % kSide)});
  }
  return result;
}

void exact_decisions(benchmark::State& state, reference::Engine engine) {
  const reference::ExactCamera exact(camera(), {});
  const auto all = pixels();
  for (std::size_t k = 0; k < 200; ++k) {
    const reference::ExactRay ray(exact, all[k]);
    if (!(ray.intersect(kSphere, scene::Root::kNearest, reference::Engine::kFieldOnly) ==
          ray.intersect(kSphere))) {
      state.SkipWithError("the filter and the field disagree");
      return;
    }
  }
  std::size_t k = 0;
  for (auto _ : state) {
    const reference::ExactRay ray(exact, all[k++ % all.size()]);
    benchmark::DoNotOptimize(ray.intersect(kSphere, scene::Root::kNearest, engine));
  }
  state.SetItemsProcessed(state.iterations());
}

void rounded_values(benchmark::State& state) {
  const reference::ExactCamera exact(camera(), {});
  std::vector<scene::Pixel> hitting;
  for (const scene::Pixel& pixel : pixels()) {
    const reference::ExactRay ray(exact, pixel);
    if (ray.intersect(kSphere).hit_class == reference::HitClass::kHit) hitting.push_back(pixel);
  }
  for (std::size_t k = 0; k < 200; ++k) {
    const reference::ExactRay ray(exact, hitting[k]);
    const auto at = ray.intersect(kSphere);
    const auto wide = ray.parameter(kSphere, at, 400);
    if (ray.rounded_parameter(kSphere, at) != wide.lower_rounded() ||
        wide.lower_rounded() != wide.upper_rounded()) {
      state.SkipWithError("a rounded parameter is not the nearest double");
      return;
    }
  }
  std::size_t k = 0;
  for (auto _ : state) {
    const reference::ExactRay ray(exact, hitting[k++ % hitting.size()]);
    benchmark::DoNotOptimize(ray.rounded_pixel_point());
    benchmark::DoNotOptimize(ray.rounded_direction());
    benchmark::DoNotOptimize(ray.rounded_parameter(kSphere, ray.intersect(kSphere)));
  }
  state.SetItemsProcessed(state.iterations());
}

void camera_set_up(benchmark::State& state) {
  for (auto _ : state) {
    const reference::ExactCamera exact(camera(), {});
    benchmark::DoNotOptimize(exact.impl());
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK_CAPTURE(exact_decisions, filtered, reference::Engine::kFiltered);
BENCHMARK_CAPTURE(exact_decisions, field_only, reference::Engine::kFieldOnly);
BENCHMARK(rounded_values)->Name("rounded_P_D_s");
BENCHMARK(camera_set_up);

}  // namespace

BENCHMARK_MAIN();
