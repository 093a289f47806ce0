#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>

#include "properties/case.h"
#include "properties/cases/random.h"
#include "scene/interruption.h"
#include "tools/tradeoff/tradeoff.h"

namespace raycheck::tools {
namespace {

using properties::Case;

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
/// Whether two points or vectors are equal bit for bit.
template <class Triple>
bool same_bits(const Triple& a, const Triple& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

constexpr const char* kDiffers = "its answers in the timed calls differ from the judged ones";

/// Calls that are timed.
struct Timed {
  std::function<void(std::size_t count)> work;
  std::size_t items = 0;
};

/// Enough inputs that no branch predictor learns them, but few enough to stay in the cache.
constexpr std::size_t kItems = 4096;
constexpr std::size_t kBatches = 8;
constexpr int kRepetitions = 21;
/// The approximate time of one candidate in a repetition; slow candidates are timed on fewer items.
constexpr double kNanosecondsPerRepetition = 2e6;

double elapsed_ns(const Timed& timed, std::size_t count) {
  const auto start = std::chrono::steady_clock::now();
  timed.work(count);
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

/// The number of items that fit into the time of a repetition, and how often they are processed.
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
    std::ranges::sort(times);
    durations.push_back(
        {times[times.size() / 2], times[times.size() / 4], times[times.size() * 3 / 4]});
  }
  return durations;
}

bool is_inside(const IntersectCall& call, const properties::Candidate& candidate) {
  scene::Scene scene;
  scene.rays = call.rays;
  scene.spheres = {call.sphere};
  return properties::is_inside_domain(candidate, scene);
}

/// The cases rounded to a candidate's format, without cases that the format cannot hold.
std::vector<Case> in_format_of(const properties::Candidate& candidate,
                               const std::vector<Case>& cases) {
  if (candidate.input_format() == properties::InputFormat{}) return cases;
  std::vector<Case> rounded;
  for (const Case& one : cases) {
    auto found = properties::rounded_case(one, candidate.input_format()).the_case;
    if (found) rounded.push_back(*std::move(found));
  }
  return rounded;
}

/// Each ray of a case with each of its spheres.
std::vector<IntersectCall> pairs_of(const std::vector<Case>& cases) {
  std::vector<IntersectCall> pairs;
  for (const Case& one : cases) {
    scene::Conventions conventions;
    conventions.root = one.scene.conventions.root;
    conventions.tangent = one.scene.conventions.tangent;
    for (const scene::Sphere& sphere : one.scene.spheres) {
      for (const scene::Ray& ray : one.scene.rays) {
        if (pairs.size() == kItems) return pairs;
        pairs.push_back({{ray}, sphere, conventions});
      }
    }
  }
  return pairs;
}

/// The ray of a pair, moved so that its position relative to another sphere is the same.
scene::Ray placed_at(const IntersectCall& pair, const scene::Sphere& sphere) {
  const double scale = pair.sphere.radius > 0 ? sphere.radius / pair.sphere.radius : 1;
  const scene::Ray& ray = pair.rays.front();
  const scene::Vector3 from_centre = ray.origin - pair.sphere.centre;
  return {{sphere.centre.x + scale * from_centre.x, sphere.centre.y + scale * from_centre.y,
           sphere.centre.z + scale * from_centre.z},
          ray.direction};
}

/// Batches with one sphere each, rounded to a format: the spheres of the first pairs with the rays
/// of all pairs.
std::vector<IntersectCall> batches_of(const std::vector<IntersectCall>& pairs,
                                      properties::InputFormat format) {
  std::vector<IntersectCall> batches;
  for (std::size_t k = 0; k < std::min(kBatches, pairs.size()); ++k) {
    batches.push_back({{}, pairs[k].sphere, pairs[k].conventions});
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    IntersectCall& batch = batches[k % batches.size()];
    batch.rays.push_back(properties::rounded_ray(placed_at(pairs[k], batch.sphere), format));
  }
  return batches;
}

bool is_same(const properties::SphereHits& a, const properties::SphereHits& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
    return one.ray == other.ray && same_bits(one.hit.parameter, other.hit.parameter) &&
           same_bits(one.hit.point, other.hit.point);
  });
}
bool is_same(const std::vector<scene::Ray>& a, const std::vector<scene::Ray>& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
    return same_bits(one.origin, other.origin) && same_bits(one.direction, other.direction);
  });
}

Duration per_item(const Duration& per_batch, std::size_t items, std::size_t batches) {
  const double share = static_cast<double>(batches) / static_cast<double>(items);
  return {per_batch.median * share, per_batch.low * share, per_batch.high * share};
}

std::vector<RaysCall> pixel_batches_of(const std::vector<Case>& cases) {
  properties::Random random(1);
  std::vector<RaysCall> batches;
  for (const Case& one : cases) {
    if (batches.size() == kBatches) break;
    RaysCall batch{*one.scene.camera, one.scene.conventions, {}};
    for (std::size_t k = 0; k < kItems / kBatches; ++k) {
      const std::int64_t i = random.integer(0, batch.camera.width - 1);
      const std::int64_t j = random.integer(0, batch.camera.height - 1);
      batch.pixels.push_back({i, j});
    }
    batches.push_back(std::move(batch));
  }
  return batches;
}

std::string only_part(std::size_t part, std::size_t whole) {
  return part == whole
             ? ""
             : fmt::format("timed on the {} of the first {} inputs that are in its domain", part,
                           whole);
}

/// The timed calls of a candidate: with one item each, and in batches.
struct Clocked {
  Timed scalar, batch;
  std::size_t items = 0;  ///< The number of items of all batches.
};

/// Prepares the calls if their answers in this process equal the judged answers bit for bit;
/// otherwise throws the reason.
template <class Prepare, class Calls, class Judged>
Timed timed_calls(const Prepare& prepare, const Calls& calls, const Judged& judged) {
  auto ready = prepare(calls);
  for (std::size_t k = 0; k < calls.size(); ++k) {
    scene::poll();
    // The judged answer comes first: if the candidate crashes, only its own process does.
    const auto expected = judged(calls[k]);
    if (!is_same(ready.answer(k), expected)) throw std::invalid_argument(kDiffers);
  }
  return {std::move(ready.run), calls.size()};
}

/// Prepares single calls and batches. If the candidate is not timed here, sets the reason.
template <class Find, class Calls, class Judged>
Clocked clocked(MethodCost& cost, const Find& find, const Calls& singles, const Calls& batches,
                const Judged& judged) {
  try {
    const auto prepare = find(cost.candidate.in_process());
    if (!prepare) throw std::invalid_argument("it makes no rays");
    Clocked found;
    // Batches come first, because they find most failures.
    found.batch = timed_calls(prepare, batches, judged);
    found.scalar = timed_calls(prepare, singles, judged);
    cost.is_called_here = !cost.candidate.methods;
    return found;
  } catch (const properties::NoAnswer& error) {
    cost.not_timed = fmt::format("not timed: {}", error.what());
  } catch (const std::invalid_argument& error) {
    cost.not_timed = fmt::format("not timed: {}", error.what());
  }
  return {};
}

/// Times the single calls and the batches of every candidate. If there are no items, the time stays
/// empty.
void time_all(const std::vector<Clocked>& clocked, std::vector<MethodCost>& costs) {
  std::vector<Timed> all;
  for (Timed Clocked::*way : {&Clocked::scalar, &Clocked::batch}) {
    for (const Clocked& one : clocked) {
      if ((one.*way).items > 0) all.push_back(one.*way);
    }
  }
  const std::vector<Duration> durations = time_interleaved(all);
  std::size_t next = 0;
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (clocked[k].scalar.items > 0) costs[k].scalar = durations[next++];
  }
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (clocked[k].batch.items == 0) continue;
    costs[k].batch = per_item(durations[next++], clocked[k].items, clocked[k].batch.items);
  }
}

}  // namespace

void time_intersections(const std::vector<Case>& cases, std::vector<MethodCost>& costs) {
  properties::ByFormat<std::vector<IntersectCall>> by_format;
  std::vector<Clocked> all;
  for (MethodCost& cost : costs) {
    const properties::Candidate candidate = cost.candidate.make();
    std::vector<IntersectCall>& pairs = by_format[candidate.input_format()];
    if (pairs.empty()) pairs = pairs_of(in_format_of(candidate, cases));
    std::vector<IntersectCall> inside;
    for (const IntersectCall& pair : pairs) {
      if (!is_inside(pair, candidate)) continue;
      inside.push_back(pair);
      inside.back().conventions = candidate.declared.over(pair.conventions);
    }
    cost.not_timed = only_part(inside.size(), pairs.size());
    const auto judged = [&](const IntersectCall& call) {
      return candidate.intersect(call.rays, {&call.sphere, 1}, call.conventions).at(0);
    };
    all.push_back(clocked(
        cost, [](const InProcess& here) { return here.intersect; }, inside,
        batches_of(inside, candidate.input_format()), judged));
    all.back().items = inside.size();
  }
  time_all(all, costs);
}

void time_rays(const std::vector<Case>& cases, std::vector<MethodCost>& costs) {
  std::vector<Clocked> all;
  for (MethodCost& cost : costs) {
    const properties::Candidate candidate = cost.candidate.make();
    std::vector<Case> inside;
    for (const Case& one : in_format_of(candidate, cases)) {
      if (properties::is_inside_domain(candidate, one.scene)) inside.push_back(one);
      if (inside.size() == kItems) break;
    }
    cost.not_timed = only_part(inside.size(), std::min(cases.size(), kItems));
    std::vector<RaysCall> singles;
    for (const Case& one : inside) {
      singles.push_back({*one.scene.camera,
                         candidate.declared.over(one.scene.conventions),
                         {one.pixels.front()}});
    }
    std::vector<RaysCall> batches = pixel_batches_of(inside);
    std::size_t items = 0;
    for (RaysCall& batch : batches) {
      batch.conventions = candidate.declared.over(batch.conventions);
      items += batch.pixels.size();
    }
    const auto judged = [&](const RaysCall& call) {
      const bool from_pixel =
          !candidate.focal_rays ||
          (call.conventions.origin == scene::Origin::kPixel && candidate.pixel_rays);
      return (from_pixel ? candidate.pixel_rays : candidate.focal_rays)(
          call.camera, call.conventions, call.pixels);
    };
    all.push_back(clocked(
        cost, [](const InProcess& here) { return here.make_rays; }, singles, batches, judged));
    all.back().items = items;
  }
  time_all(all, costs);
}

}  // namespace raycheck::tools
