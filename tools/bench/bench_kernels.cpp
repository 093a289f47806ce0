// Kernels: fixed pieces of work on one thread. A kernel is timed only after its answers were
// checked.
//   --target=NAME   is taken by choose_target; all else is Google Benchmark's
//   --check         checks the answers of every kernel and says how the program was built
//   --count         under valgrind --tool=callgrind --collect-atstart=no, dumps one count a kernel

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define RAYCHECK_HAS_CALLGRIND
#endif

#include <benchmark/benchmark.h>
#include <gnu/libc-version.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/search/campaign.h"
#include "reference/error_measure.h"
#include "reference/exact_ray.h"
#include "reference/ray_error.h"
#include "reference/visibility/visibility.h"
#include "tools/bench/bench_scenes.h"
#include "tools/check/check.h"
#include "tools/implementations/built_in.h"

namespace {

using namespace raycheck;

struct Kernel {
  std::string name;
  std::size_t items;
  std::function<void()> work;
  std::function<bool()> is_right;  ///< Whether the answers of the last run are right.
};

constexpr std::int64_t kSide = 512;
constexpr std::int64_t kImageSide = 64;

std::vector<scene::Pixel> some_pixels(std::size_t count) {
  auto pixels = tools::scattered_pixels(kSide);
  pixels.resize(count);
  return pixels;
}

/// A kernel of `count` answers: work(k) is the k-th, which is_right(k, answer) checks.
template <class Work, class IsRight>
Kernel each(std::string name, std::size_t count, const Work& work, const IsRight& is_right) {
  using Answer = std::invoke_result_t<Work, std::size_t>;
  const auto answers = std::make_shared<std::vector<Answer>>(count);
  return {std::move(name), count,
          [=] {
            for (std::size_t k = 0; k < count; ++k) (*answers)[k] = work(k);
          },
          [=] {
            std::size_t k = 0;
            while (k < count && is_right(k, (*answers)[k])) ++k;
            return k == count;
          }};
}

Kernel exact_decisions() {
  const reference::ExactCamera camera(*tools::camera_of(kSide, kSide).camera, {});
  const auto pixels = some_pixels(4000);
  const auto answer = [=](std::size_t k, reference::Engine engine) {
    return reference::ExactRay(camera, pixels[k])
        .intersect(tools::kBenchSphere, scene::Root::kNearest, {engine});
  };
  return each(
      "exact-decisions", pixels.size(),
      [=](std::size_t k) { return answer(k, reference::Engine::kFiltered); },
      [=](std::size_t k, const reference::Intersection& got) {
        return got == answer(k, reference::Engine::kFieldOnly);
      });
}

Kernel rounded_values() {
  const reference::ExactCamera camera(*tools::camera_of(kSide, kSide).camera, {});
  std::vector<scene::Pixel> pixels;
  for (const scene::Pixel& pixel : some_pixels(4000)) {
    const auto at = reference::ExactRay(camera, pixel).intersect(tools::kBenchSphere);
    if (at.hit_class == reference::HitClass::kHit) pixels.push_back(pixel);
  }
  struct Values {
    scene::Point3 point;
    scene::UnitVector3 direction;
    double parameter;
  };
  return each(
      "rounded-values", pixels.size(),
      [=](std::size_t k) {
        const reference::ExactRay ray(camera, pixels[k]);
        return Values{
            ray.rounded_pixel_point(), ray.rounded_direction(),
            ray.rounded_parameter(tools::kBenchSphere, ray.intersect(tools::kBenchSphere))};
      },
      [=](std::size_t k, const Values& got) {
        const reference::ExactRay ray(camera, pixels[k]);
        const auto at = ray.intersect(tools::kBenchSphere);
        const auto is_nearest = [](double value, const reference::Enclosure& wide) {
          return value == wide.lower_rounded() && value == wide.upper_rounded();
        };
        return is_nearest(got.parameter, ray.parameter(tools::kBenchSphere, at, 400)) &&
               is_nearest(got.point.x, ray.pixel_point(400).x) &&
               is_nearest(got.direction.y, ray.direction(400).y);
      });
}

Kernel certified_s() {
  auto cases = tools::hitting_cases();
  cases.resize(2000);
  return each(
      "certified-s", cases.size(),
      [=](std::size_t k) {
        const auto& [given, sphere, answer] = cases[k];
        const reference::ExactRay ray(given);
        const auto at = ray.intersect(sphere);
        return reference::parameter_error(ray, sphere, at, answer, scene::Precision::kDouble).value;
      },
      [=](std::size_t k, double error) {
        const auto& [given, sphere, answer] = cases[k];
        const reference::ExactRay ray(given);
        const auto at =
            ray.intersect(sphere, scene::Root::kNearest, {reference::Engine::kFieldOnly});
        const double exact = reference::ulp_error(answer, ray.parameter(sphere, at, 400)).value;
        return error >= exact && error <= exact + 0x1p-10;
      });
}

Kernel rays_of_pixels(const fast::PixelRayMethod& method) {
  const scene::Scene scene = tools::scene_in_view();
  const auto pixels = properties::all_pixels(*scene.camera);
  const auto make = method.pixel_rays != nullptr ? method.pixel_rays : method.focal_rays;
  const auto rays = std::make_shared<fast::Rays>();
  return {"rays/" + std::string(method.name), pixels.size(),
          [=] { make(*scene.camera, scene.conventions, pixels, *rays); },
          [&method, scene] { return tools::wrong_answers(method, fast::kCross, scene).empty(); }};
}

Kernel intersections(const fast::IntersectMethod& method) {
  const scene::Scene scene = tools::unrelated_rays();
  const fast::Rays rays = tools::rays_of(scene);
  const auto hits = std::make_shared<fast::Hits>();
  return {
      "intersect/" + std::string(method.name), rays.size(),
      [=, &method] { method.intersect(rays, scene.spheres.front(), {}, *hits); },
      [&method, scene] { return tools::wrong_answers(fast::kDirectRays, method, scene).empty(); }};
}

Kernel certified_image(std::int64_t spheres) {
  const scene::Scene scene = tools::in_view(spheres, kImageSide);
  const auto visibility = std::make_shared<const reference::Visibility>(
      scene, scene::plan_scene(scene, scene.conventions, scene::Wanted::kNearest));
  constexpr auto kPixels = static_cast<std::size_t>(kImageSide * kImageSide);
  const auto seen = std::make_shared<std::vector<std::int32_t>>(kPixels);
  const auto parameters = std::make_shared<std::vector<double>>(kPixels);
  return {"image/" + std::to_string(spheres), kPixels,
          [=] {
            visibility->nearest(0, kImageSide, {*seen, *parameters, {}, {}, {}});
          },
          [=] {
            const reference::ExactCamera camera(*scene.camera, scene.conventions);
            const std::size_t step = 1 + static_cast<std::size_t>(spheres) / 100;
            for (std::size_t k = 0; k < kPixels; k += step) {
              const auto index = static_cast<std::int64_t>(k);
              const auto nearest =
                  reference::ExactRay(camera, {index % kImageSide, index / kImageSide})
                      .nearest(scene.spheres, scene.conventions);
              if ((*seen)[k] != (nearest ? static_cast<std::int32_t>(nearest->index) : -1)) {
                return false;
              }
            }
            return true;
          }};
}

Kernel campaign(const char* subject, const char* law) {
  const auto result = std::make_shared<properties::CampaignResult>();
  const properties::Candidate candidate = tools::candidate_of(tools::kDefaultMethods);
  properties::CampaignOptions options;
  options.cases = 40;
  options.level = properties::Level::kOrdinary;
  return {"campaign/" + std::string(subject), static_cast<std::size_t>(options.cases),
          [=] { *result = run_campaign(*properties::find_law(law), candidate, options); },
          [=] { return !result->failure && result->verdict.compared() > 0; }};
}

/// All laws in one pass, on one thread.
Kernel campaigns() {
  constexpr int kCases = 50;
  properties::LawsOfCandidate asked;
  for (const properties::Law& law : properties::laws()) asked.laws.push_back(&law);
  asked.options.cases = kCases;
  asked.options.level = properties::Level::kOrdinary;
  const properties::Candidate candidate = tools::candidate_of(tools::kDefaultMethods);
  const auto broken = std::make_shared<std::size_t>();
  return {"campaign/all laws", kCases * asked.laws.size(),
          [=] {
            *broken = 0;
            properties::Campaigns all({asked});
            for (std::size_t unit = 0; unit < all.unit_count(); ++unit) {
              all.take(unit, all.run(unit, {&candidate, 1}, {}));
            }
            for (std::size_t law = 0; law < asked.laws.size(); ++law) {
              *broken += all.finished(0, law, candidate).failure ? 1 : 0;
            }
          },
          [=] { return *broken == 0; }};
}

/// Makes an exact camera, the exact ray of one pixel, and its hit class.
Kernel set_up() {
  constexpr std::size_t kCameras = 1000;
  const scene::Camera camera = *tools::camera_of(kSide, kSide).camera;
  const auto at = [=](std::size_t k) {
    scene::Camera moved = camera;
    moved.eye.x += static_cast<double>(k) / kCameras;
    return moved;
  };
  const scene::Pixel middle = {kSide / 2, kSide / 2};
  const auto answer = [=](std::size_t k, reference::Engine engine) {
    return reference::ExactRay(reference::ExactCamera(at(k), {}), middle)
        .intersect(tools::kBenchSphere, scene::Root::kNearest, {engine});
  };
  return each(
      "camera/set-up", kCameras,
      [=](std::size_t k) { return answer(k, reference::Engine::kFiltered); },
      [=](std::size_t k, const reference::Intersection& got) {
        return got == answer(k, reference::Engine::kFieldOnly);
      });
}

Kernel check_of_scene() {
  tools::CheckOptions options;
  options.path = RAYCHECK_EXAMPLES "/ten-spheres.toml";
  options.implementations = {tools::built_in(tools::kDefaultMethods)};
  options.pixels = 200;
  const auto report = std::make_shared<tools::CheckReport>();
  return {"check/ten-spheres", static_cast<std::size_t>(*options.pixels),
          [=] { *report = tools::check(options); },
          [=] { return report->discrepancies() == 0 && report->compared() > 0; }};
}

std::vector<Kernel> kernels() {
  std::vector<Kernel> result = {exact_decisions(), rounded_values(), certified_s()};
  for (const auto* method : fast::pixel_ray_methods()) result.push_back(rays_of_pixels(*method));
  for (const auto* method : fast::intersect_methods()) result.push_back(intersections(*method));
  for (const std::int64_t spheres : {1, 100, 10'000}) result.push_back(certified_image(spheres));
  result.push_back(campaign("camera", "direction"));
  result.push_back(campaign("intersection", "parameter"));
  result.push_back(campaign("both", "hit-point"));
  result.push_back(campaigns());
  result.push_back(set_up());
  result.push_back(check_of_scene());
  return result;
}

/// The compiler and build type, on which counts depend, too; counts.py compares them with the
/// baseline's.
std::string built_by() {
#ifndef RAYCHECK_HAS_CALLGRIND
  return "a build without valgrind/callgrind.h";
#endif
#ifdef __clang__
  const std::string compiler = "clang++ " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return compiler + ", " RAYCHECK_BUILD_TYPE ", glibc " + gnu_get_libc_version();
}

/// Counts the second run, because the first allocates memory for the answers.
void count([[maybe_unused]] const Kernel& kernel) {
#ifdef RAYCHECK_HAS_CALLGRIND
  kernel.work();
  CALLGRIND_ZERO_STATS;
  CALLGRIND_TOGGLE_COLLECT;
  kernel.work();
  CALLGRIND_TOGGLE_COLLECT;
  CALLGRIND_DUMP_STATS_AT(kernel.name.c_str());
#endif
}

bool is_right(const Kernel& kernel) {
  kernel.work();
  if (kernel.is_right()) return true;
  std::cerr << kernel.name << ": its answers are wrong\n";
  return false;
}

void time_kernel(benchmark::State& state, const Kernel& kernel) {
  if (!is_right(kernel)) {
    state.SkipWithError("its answers are wrong");
    return;
  }
  for (auto _ : state) {
    kernel.work();
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kernel.items));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view mode = argc == 2 ? argv[1] : "";
  const bool checks = mode == "--check", counts = mode == "--count";
  // Counts use the widest target of Highway that valgrind supports and most machines have.
  if (!tools::choose_target(argc, argv, checks || counts ? "AVX2" : "")) return 2;
  const std::vector<Kernel> all = kernels();
  if (checks) {
    std::cout << built_by() << "\n";
    return std::ranges::all_of(all, is_right) ? 0 : 1;
  }
  if (counts) {
    for (const Kernel& kernel : all) count(kernel);
    return 0;
  }
  for (const Kernel& kernel : all) {
    benchmark::RegisterBenchmark(kernel.name.c_str(), time_kernel, kernel);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
