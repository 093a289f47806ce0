#include "tools/tradeoff/tradeoff_timing.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <limits>

#include "fast/batch.h"
#include "properties/cases/random.h"
#include "properties/rounded_case.h"
#include "scene/interruption.h"
#include "tools/tradeoff/tradeoff_items.h"
#include "tools/tradeoff/tradeoff_others.h"

namespace raycheck::tools {
namespace {

using properties::Case;

/// Enough inputs that no branch predictor learns them, few enough to stay in the cache.
constexpr std::size_t kItems = 4096;
constexpr std::size_t kBatches = 8;
constexpr int kRepetitions = 21;
/// What one method may take of one repetition, at about; slow ones are timed on fewer items.
constexpr double kNanosecondsPerRepetition = 2e6;

double elapsed_ns(const Timed& timed, std::size_t count) {
  const auto start = std::chrono::steady_clock::now();
  timed.work(count);
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

/// As many items as fit the time of a repetition, and how often they are worked on.
struct Load {
  std::size_t count;
  int times;
};

Load load_of(const Timed& timed) {
  std::size_t count = std::min<std::size_t>(timed.items, 16);
  for (;;) {
    const double elapsed = elapsed_ns(timed, count);
    if (elapsed > kNanosecondsPerRepetition || count == timed.items) {
      const double times = kNanosecondsPerRepetition / std::max(elapsed, 1.0);
      return {count, std::max(1, static_cast<int>(std::min(times, 1000.0)))};
    }
    count = std::min(count * 2, timed.items);
  }
}

std::vector<Duration> time_interleaved(const std::vector<Timed>& all) {
  std::vector<Load> loads;
  for (const Timed& timed : all) {
    scene::poll();
    loads.push_back(load_of(timed));
  }
  std::vector<std::vector<double>> seen(all.size());
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      scene::poll();
      double elapsed = 0;
      for (int time = 0; time < loads[k].times; ++time) {
        elapsed += elapsed_ns(all[k], loads[k].count);
      }
      seen[k].push_back(elapsed / static_cast<double>(loads[k].count) / loads[k].times);
    }
  }
  std::vector<Duration> durations;
  for (std::vector<double>& times : seen) {
    std::sort(times.begin(), times.end());
    durations.push_back(
        {times[times.size() / 2], times[times.size() / 4], times[times.size() * 3 / 4]});
  }
  return durations;
}

bool is_inside(const Pair& pair, const properties::Candidate& candidate) {
  scene::Scene scene;
  scene.rays = {pair.ray};
  scene.spheres = {pair.sphere};
  return properties::is_inside_domain(candidate, scene);
}

/// The cases in the format that a candidate is asked in; those that it cannot hold are left out.
std::vector<Case> in_format_of(const properties::Candidate& candidate,
                               const std::vector<Case>& cases) {
  if (candidate.precision == scene::Precision::kDouble) return cases;
  std::vector<Case> rounded;
  for (const Case& one : cases) {
    auto found = properties::rounded_case(one, candidate.precision).the_case;
    if (found) rounded.push_back(*std::move(found));
  }
  return rounded;
}

std::vector<Pair> pairs_of(const std::vector<Case>& cases) {
  std::vector<Pair> pairs;
  for (const Case& one : cases) {
    for (const scene::Sphere& sphere : one.scene.spheres) {
      for (const scene::Ray& ray : one.scene.rays) {
        if (pairs.size() == kItems) return pairs;
        pairs.push_back({ray, sphere, one.scene.conventions.root, one.scene.conventions.tangent});
      }
    }
  }
  return pairs;
}

void append(fast::Rays& rays, const scene::Ray& ray) {
  rays.origin.x.push_back(ray.origin.x);
  rays.origin.y.push_back(ray.origin.y);
  rays.origin.z.push_back(ray.origin.z);
  rays.direction.x.push_back(ray.direction.x);
  rays.direction.y.push_back(ray.direction.y);
  rays.direction.z.push_back(ray.direction.z);
}

/// The ray of one pair, placed to another's sphere as it was to its own.
scene::Ray placed_at(const Pair& pair, const scene::Sphere& sphere) {
  const double scale = pair.sphere.radius > 0 ? sphere.radius / pair.sphere.radius : 1;
  const scene::Vector3 from_centre = pair.ray.origin - pair.sphere.centre;
  return {{sphere.centre.x + scale * from_centre.x, sphere.centre.y + scale * from_centre.y,
           sphere.centre.z + scale * from_centre.z},
          pair.ray.direction};
}

/// The pairs in batches of one sphere each: the spheres of the first pairs, met by the rays of all,
/// whose numbers are of a format.
std::vector<Batch> batches_of(const std::vector<Pair>& pairs, scene::Precision precision) {
  std::vector<Batch> batches;
  for (std::size_t k = 0; k < std::min(kBatches, pairs.size()); ++k) {
    batches.push_back({{}, pairs[k].sphere, pairs[k].root, pairs[k].tangent});
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    Batch& batch = batches[k % batches.size()];
    append(batch.rays, properties::rounded_ray(placed_at(pairs[k], batch.sphere), precision));
  }
  return batches;
}

bool batch_is_single_calls(const fast::IntersectMethod& method, const Batch& batch) {
  fast::Hits hits;
  method.intersect(batch.rays, batch.sphere, batch.root, batch.tangent, hits);
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const auto one =
        method.intersect_one(ray_at(batch.rays, k), batch.sphere, batch.root, batch.tangent);
    if (one.has_value() != (hits.hit[k] != 0)) return false;
    if (one &&
        !(same_bits(one->parameter, hits.parameter[k]) &&
          same_bits(one->point.x, hits.point.x[k]) && same_bits(one->point.y, hits.point.y[k]) &&
          same_bits(one->point.z, hits.point.z[k]))) {
      return false;
    }
  }
  return true;
}

Timed single_calls(const fast::IntersectMethod& method, const std::vector<Pair>& pairs) {
  return {[&method, &pairs](std::size_t count) {
            for (std::size_t k = 0; k < count; ++k) {
              const Pair& pair = pairs[k];
              keep(method.intersect_one(pair.ray, pair.sphere, pair.root, pair.tangent));
            }
          },
          pairs.size()};
}

/// Items are whole batches here, the rays of all of them taken together.
Timed batch_calls(const fast::IntersectMethod& method, const std::vector<Batch>& batches) {
  return {[&method, &batches, hits = fast::Hits{}](std::size_t count) mutable {
            for (std::size_t k = 0; k < count; ++k) {
              const Batch& batch = batches[k];
              method.intersect(batch.rays, batch.sphere, batch.root, batch.tangent, hits);
              keep(hits);
            }
          },
          batches.size()};
}

Duration per_item(const Duration& per_batch, std::size_t items, std::size_t batches) {
  const double share = static_cast<double>(batches) / static_cast<double>(items);
  return {per_batch.median * share, per_batch.low * share, per_batch.high * share};
}

std::vector<PixelBatch> pixel_batches_of(const std::vector<Case>& cases) {
  properties::Random random(1);
  std::vector<PixelBatch> batches;
  for (const Case& one : cases) {
    if (batches.size() == kBatches) break;
    PixelBatch batch{*one.scene.camera, one.scene.conventions, {}};
    for (std::size_t k = 0; k < kItems / kBatches; ++k) {
      const std::int64_t i = random.integer(0, batch.camera.width - 1);
      const std::int64_t j = random.integer(0, batch.camera.height - 1);
      batch.pixels.push_back({i, j});
    }
    batches.push_back(std::move(batch));
  }
  return batches;
}

fast::PixelRayMethod::MakeRays maker(const fast::PixelRayMethod& method,
                                     const scene::Conventions& conventions) {
  return conventions.origin == scene::Origin::kPixel && method.pixel_rays != nullptr
             ? method.pixel_rays
             : method.focal_rays;
}

bool batch_is_single_calls(const fast::PixelRayMethod& method, const PixelBatch& batch) {
  const auto make = maker(method, batch.conventions);
  fast::Rays all;
  fast::Rays one;
  make(batch.camera, batch.conventions, batch.pixels, all);
  for (std::size_t k = 0; k < batch.pixels.size(); ++k) {
    make(batch.camera, batch.conventions, {&batch.pixels[k], 1}, one);
    const scene::Ray a = ray_at(all, k);
    const scene::Ray b = ray_at(one, 0);
    const auto same = [](const auto& v, const auto& w) {
      return same_bits(v.x, w.x) && same_bits(v.y, w.y) && same_bits(v.z, w.z);
    };
    if (!same(a.origin, b.origin) || !same(a.direction, b.direction)) return false;
  }
  return true;
}

std::string only_part(std::size_t part, std::size_t whole) {
  return part == whole ? ""
                       : fmt::format("timed on the {} of {} inputs in its domain", part, whole);
}

/// Runs the stopwatch over every cost's two ways of being called; where one has no items, it stays
/// empty.
template <class Items>
void fill_in(const std::vector<Items>& items, const std::vector<Timed>& scalars,
             const std::vector<Timed>& batches, std::vector<MethodCost>& costs) {
  std::vector<Timed> all;
  for (const auto* list : {&scalars, &batches}) {
    for (const Timed& timed : *list) {
      if (timed.items > 0) all.push_back(timed);
    }
  }
  const std::vector<Duration> durations = time_interleaved(all);
  std::size_t next = 0;
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (scalars[k].items > 0) costs[k].scalar = durations[next++];
  }
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (batches[k].items == 0) continue;
    costs[k].batch = per_item(durations[next++], items[k].size(), batches[k].items);
  }
}

void add_others(OthersTimed timed, std::vector<Timed>& scalars, std::vector<Timed>& whole,
                MethodCost& cost) {
  cost.is_called_here = timed.not_timed.empty();
  if (!timed.not_timed.empty()) cost.not_timed = std::move(timed.not_timed);
  scalars.push_back(std::move(timed.single));
  whole.push_back(std::move(timed.batch));
}

}  // namespace

void time_intersections(const std::vector<Case>& cases, std::vector<MethodCost>& costs) {
  std::array<std::vector<Pair>, scene::kFormats.size()> by_format = {pairs_of(cases), {}};
  std::vector<std::vector<Pair>> pairs(costs.size());
  std::vector<std::vector<Batch>> batches(costs.size());
  std::vector<Timed> scalars;
  std::vector<Timed> whole;
  for (std::size_t k = 0; k < costs.size(); ++k) {
    const fast::IntersectMethod& method = *costs[k].method.intersect;
    const properties::Candidate candidate = candidate_of(costs[k].method);
    std::vector<Pair>& all = by_format[static_cast<std::size_t>(candidate.precision)];
    if (all.empty()) all = pairs_of(in_format_of(candidate, cases));
    for (const Pair& pair : all) {
      if (is_inside(pair, candidate)) pairs[k].push_back(pair);
    }
    costs[k].not_timed = only_part(pairs[k].size(), all.size());
    batches[k] = batches_of(pairs[k], candidate.precision);
    if (costs[k].method.other) {
      add_others(others_intersections(*costs[k].method.other, candidate, pairs[k], batches[k]),
                 scalars, whole, costs[k]);
      continue;
    }
    scalars.push_back(single_calls(method, pairs[k]));
    const bool same = std::all_of(batches[k].begin(), batches[k].end(), [&](const Batch& batch) {
      return batch_is_single_calls(method, batch);
    });
    if (!same) costs[k].not_timed = "batches answer differently from single calls";
    whole.push_back(same ? batch_calls(method, batches[k]) : Timed{});
  }
  fill_in(pairs, scalars, whole, costs);
}

void time_rays(const std::vector<Case>& cases, std::vector<MethodCost>& costs) {
  std::vector<std::vector<PixelBatch>> singles(costs.size());
  std::vector<std::vector<PixelBatch>> batches(costs.size());
  std::vector<std::vector<scene::Pixel>> items(costs.size());
  std::vector<Timed> scalars;
  std::vector<Timed> whole;
  for (std::size_t k = 0; k < costs.size(); ++k) {
    const fast::PixelRayMethod& method = *costs[k].method.rays;
    const properties::Candidate candidate = candidate_of(costs[k].method);
    std::vector<Case> inside;
    for (const Case& one : in_format_of(candidate, cases)) {
      if (properties::is_inside_domain(candidate, one.scene)) inside.push_back(one);
      if (inside.size() == kItems) break;
    }
    costs[k].not_timed = only_part(inside.size(), std::min(cases.size(), kItems));
    for (const Case& one : inside) {
      singles[k].push_back({*one.scene.camera, one.scene.conventions, {one.pixels.front()}});
    }
    batches[k] = pixel_batches_of(inside);
    for (const PixelBatch& batch : batches[k]) {
      items[k].insert(items[k].end(), batch.pixels.begin(), batch.pixels.end());
    }
    if (costs[k].method.other) {
      add_others(others_rays(*costs[k].method.other, candidate, singles[k], batches[k]), scalars,
                 whole, costs[k]);
      continue;
    }
    const auto work = [&method](const std::vector<PixelBatch>& list) {
      return Timed{[&method, &list, rays = fast::Rays{}](std::size_t count) mutable {
                     for (std::size_t at = 0; at < count; ++at) {
                       const PixelBatch& batch = list[at];
                       maker(method, batch.conventions)(batch.camera, batch.conventions,
                                                        batch.pixels, rays);
                       keep(rays);
                     }
                   },
                   list.size()};
    };
    scalars.push_back(work(singles[k]));
    const bool same =
        std::all_of(batches[k].begin(), batches[k].end(),
                    [&](const PixelBatch& batch) { return batch_is_single_calls(method, batch); });
    if (!same) costs[k].not_timed = "batches answer differently from single calls";
    whole.push_back(same ? work(batches[k]) : Timed{});
  }
  fill_in(items, scalars, whole, costs);
}

std::vector<Duration> time_pixels(const Case& the_case, const std::vector<MethodPair>& pairs) {
  const scene::Conventions& conventions = the_case.scene.conventions;
  std::vector<scene::Pixel> pixels = the_case.pixels;
  pixels.resize(std::min(pixels.size(), kItems));
  std::vector<Timed> all;
  for (const MethodPair& pair : pairs) {
    all.push_back(
        {[&, pair, rays = fast::Rays{}, hits = fast::Hits{}](std::size_t) mutable {
           maker(*pair.rays, conventions)(*the_case.scene.camera, conventions, pixels, rays);
           for (const scene::Sphere& sphere : the_case.scene.spheres) {
             pair.intersect->intersect(rays, sphere, conventions.root, conventions.tangent, hits);
             keep(hits);
           }
         },
         1});
  }
  std::vector<Duration> durations = time_interleaved(all);
  for (Duration& duration : durations) duration = per_item(duration, pixels.size(), 1);
  return durations;
}

}  // namespace raycheck::tools
