// How many exact answers per second. Every benchmark checks its answers against the exact field or
// a wider enclosure before it is timed.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "reference/condition.h"
#include "reference/error_measure.h"
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

/// A given ray that hits, and an answer that is off by a few ulps.
struct GivenCase {
  scene::Ray ray;
  scene::Sphere sphere;
  double answer;
};

double between(std::uint64_t& state, double low, double high) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return low + static_cast<double>(state >> 11) * 0x1p-53 * (high - low);
}

std::vector<GivenCase> hitting_cases() {
  std::vector<GivenCase> result;
  std::uint64_t state = 7;
  const auto triple = [&state](double size) {
    const double x = between(state, -size, size);
    const double y = between(state, -size, size);
    return scene::Point3{x, y, between(state, -size, size)};
  };
  while (result.size() < 1 << 14) {
    const auto origin = triple(9);
    const auto direction = triple(1);
    const auto centre = triple(12);
    const scene::Ray ray{origin, {direction.x, direction.y, direction.z}};
    const scene::Sphere sphere{centre, between(state, 0, 12)};
    const reference::ExactRay exact(ray);
    const auto at = exact.intersect(sphere);
    if (at.hit_class != reference::HitClass::kHit) continue;
    const double noise = between(state, -8, 8) * 0x1p-52;
    result.push_back({ray, sphere, exact.rounded_parameter(sphere, at) * (1 + noise)});
  }
  return result;
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
