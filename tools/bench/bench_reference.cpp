// How many exact answers per second. Every benchmark checks its answers against the exact field or
// a wider enclosure before it is timed.

#include <benchmark/benchmark.h>

#include <vector>

#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/exact_ray.h"
#include "tools/bench/bench_scenes.h"

namespace {

using namespace raycheck;
using tools::hitting_cases;

constexpr int kSide = 512;
constexpr scene::Sphere kSphere = tools::kBenchSphere;

scene::Camera camera() { return *tools::camera_of(kSide, kSide).camera; }
std::vector<scene::Pixel> pixels() { return tools::scattered_pixels(kSide); }

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

/// Class, narrow enclosure and certified error in ulp of one s.
void certified_s(benchmark::State& state) {
  const auto cases = hitting_cases();
  for (std::size_t k = 0; k < 200; ++k) {
    const auto& [given, sphere, answer] = cases[k];
    const reference::ExactRay ray(given);
    const auto at = ray.intersect(sphere);
    const auto exact_at =
        ray.intersect(sphere, scene::Root::kNearest, reference::Engine::kFieldOnly);
    const double error = reference::ulp_error(answer, ray.parameter(sphere, at));
    const double exact_error = reference::ulp_error(answer, ray.parameter(sphere, at, 400));
    if (!(at == exact_at) || error < exact_error || error > exact_error + 0x1p-10) {
      state.SkipWithError("a certified error is not what the exact field and 400 bits say");
      return;
    }
  }
  std::size_t k = 0;
  for (auto _ : state) {
    const auto& [given, sphere, answer] = cases[k++ % cases.size()];
    const reference::ExactRay ray(given);
    const auto at = ray.intersect(sphere);
    benchmark::DoNotOptimize(reference::ulp_error(answer, ray.parameter(sphere, at)));
  }
  state.SetItemsProcessed(state.iterations());
}

/// The parts of certified_s.
void given_ray(benchmark::State& state) {
  const auto cases = hitting_cases();
  std::size_t k = 0;
  for (auto _ : state) {
    const reference::ExactRay ray(cases[k++ % cases.size()].ray);
    benchmark::DoNotOptimize(&ray);
  }
}
void given_class(benchmark::State& state) {
  const auto cases = hitting_cases();
  std::size_t k = 0;
  for (auto _ : state) {
    const auto& [given, sphere, answer] = cases[k++ % cases.size()];
    const reference::ExactRay ray(given);
    benchmark::DoNotOptimize(ray.intersect(sphere));
  }
}
void given_parameter(benchmark::State& state) {
  const auto cases = hitting_cases();
  std::size_t k = 0;
  for (auto _ : state) {
    const auto& [given, sphere, answer] = cases[k++ % cases.size()];
    const reference::ExactRay ray(given);
    benchmark::DoNotOptimize(ray.parameter(sphere, ray.intersect(sphere)));
  }
}

void condition_of_given_parameter(benchmark::State& state) {
  const auto cases = hitting_cases();
  for (std::size_t k = 0; k < 200; ++k) {
    const auto& [given, sphere, answer] = cases[k];
    const reference::ExactRay ray(given);
    const auto at = ray.intersect(sphere);
    const double balls =
        reference::condition_of_parameter(ray, sphere, at, reference::Arithmetic::kBallsOnly);
    const double ratio = reference::condition_of_parameter(ray, sphere, at) / balls;
    if (!(ratio >= 1 - 2 * reference::kConditionWidth) ||
        !(ratio <= 1 + 2 * reference::kConditionWidth)) {
      state.SkipWithError("intervals and balls disagree about a condition number");
      return;
    }
  }
  std::size_t k = 0;
  for (auto _ : state) {
    const auto& [given, sphere, answer] = cases[k++ % cases.size()];
    const reference::ExactRay ray(given);
    const auto at = ray.intersect(sphere);
    benchmark::DoNotOptimize(reference::condition_of_parameter(ray, sphere, at));
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
BENCHMARK(certified_s);
BENCHMARK(given_ray);
BENCHMARK(given_class);
BENCHMARK(given_parameter);
BENCHMARK(condition_of_given_parameter);
BENCHMARK(camera_set_up);

}  // namespace

BENCHMARK_MAIN();
