#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include "scene/interruption.h"
#include "tools/plan/plan.h"

namespace raycheck::tools {
namespace {

using reference::Visibility;
using scene::Wanted;
using Clock = std::chrono::steady_clock;

/// Approximate limits on the time for everything and for one item, and the resolution of a clock.
constexpr double kAllSeconds = 2;
constexpr double kItemSeconds = 0.15;
constexpr double kLeastSeconds = 20e-6;
constexpr int kMostPasses = 9;
/// At most this many pairs of spheres and pixels are computed at a time.
constexpr double kMostPairs = 1e8;
/// At most this many pixels are computed at a time, to limit the memory.
constexpr double kMostPixelsAtATime = 1 << 22;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The timed work: computes the wanted quantities of a scene's rows into arrays.
class Workload {
 public:
  Workload(const scene::Scene& scene, Wanted wanted, std::int64_t rows)
      : width_(static_cast<std::size_t>(scene.camera->width)), wanted_(wanted) {
    const std::size_t pixels = width_ * static_cast<std::size_t>(rows);
    if (wanted == Wanted::kClass) {
      classes_.resize(pixels);
      return;
    }
    sphere_.resize(pixels);
    if (wanted == Wanted::kParameter || wanted == Wanted::kPoint) parameter_.resize(pixels);
    if (wanted == Wanted::kPoint) {
      for (auto* coordinate : {&x_, &y_, &z_}) coordinate->resize(pixels);
    }
  }

  reference::DecidedBy run(const Visibility& visibility, std::int64_t j_begin, std::int64_t j_end) {
    const std::size_t pixels = width_ * static_cast<std::size_t>(j_end - j_begin);
    if (wanted_ == Wanted::kClass) {
      reference::DecidedBy decided_by;
      const auto& spheres = visibility.plan().spheres;
      for (std::size_t k = 0; k < spheres.size(); ++k) {
        if (spheres[k].left_out) continue;
        decided_by += visibility.classes(k, j_begin, j_end, std::span(classes_).subspan(0, pixels));
      }
      return decided_by;
    }
    const auto room = [pixels](auto& array) {
      return std::span(array).subspan(0, std::min(pixels, array.size()));
    };
    return visibility.nearest(j_begin, j_end,
                              {room(sphere_), room(parameter_), room(x_), room(y_), room(z_)});
  }

 private:
  std::size_t width_;
  Wanted wanted_;
  std::vector<reference::HitClass> classes_;
  std::vector<std::int32_t> sphere_;
  std::vector<double> parameter_, x_, y_, z_;
};

/// An image's rows in bands. Their order is such that the first k bands, for any k, are spread over
/// the image.
class Bands {
 public:
  Bands(std::int64_t height, std::int64_t rows)
      : height_(height), rows_(rows), count_((height + rows - 1) / rows) {
    constexpr double kGoldenSection = 0.6180339887498949;
    step_ = std::max<std::int64_t>(1, std::llround(kGoldenSection * static_cast<double>(count_)));
    while (std::gcd(step_, count_) != 1) --step_;
  }

  std::size_t count() const { return static_cast<std::size_t>(count_); }
  std::pair<std::int64_t, std::int64_t> operator[](std::size_t k) const {
    const std::int64_t begin = static_cast<std::int64_t>(k) * step_ % count_ * rows_;
    return {begin, std::min(height_, begin + rows_)};
  }
  std::int64_t most_rows() const { return std::min(rows_, height_); }

 private:
  std::int64_t height_, rows_, count_, step_;
};

/// The seconds that some rows take; repeats them until the clock resolves the time.
double time_rows(const Visibility& visibility, Workload& workload,
                 const std::pair<std::int64_t, std::int64_t>& rows) {
  const Clock::time_point start = Clock::now();
  int repetitions = 0;
  do {
    workload.run(visibility, rows.first, rows.second);
    ++repetitions;
  } while (seconds_since(start) < kLeastSeconds);
  return seconds_since(start) / repetitions;
}

/// The times of several visibilities, in milliseconds for the whole image. They are measured on the
/// first bands of the image, at least one and as many as fit into the time limit: the sum, over the
/// bands, of the shortest of several passes. The visibilities take turns, so that disturbances of
/// the machine slow all of them.
struct PartTimes {
  std::vector<double> image_ms;
  std::size_t bands = 0;
  std::int64_t rows = 0;  ///< The number of rows of these bands together.
};
PartTimes time_parts(const std::vector<const Visibility*>& all, Workload& workload,
                     const Bands& bands, std::int64_t height) {
  const Clock::time_point start = Clock::now();
  std::vector<std::vector<double>> least(all.size(), std::vector<double>(bands.count(), HUGE_VAL));
  PartTimes times{{}, bands.count()};
  for (int pass = 0; pass < kMostPasses; ++pass) {
    if (pass > 0 && seconds_since(start) > kItemSeconds) break;
    for (std::size_t part = 0; part < times.bands; ++part) {
      const auto rows = bands[part];
      for (std::size_t k = 0; k < all.size(); ++k) {
        least[k][part] = std::min(least[k][part], time_rows(*all[k], workload, rows));
      }
      if (pass > 0) continue;
      times.rows += rows.second - rows.first;
      // The first pass may take half of the time, to leave time for a second.
      if (seconds_since(start) > kItemSeconds / 2) times.bands = part + 1;
    }
  }
  for (const auto& of : least) {
    const auto end = of.begin() + static_cast<std::ptrdiff_t>(times.bands);
    times.image_ms.push_back(1e3 * std::accumulate(of.begin(), end, 0.0) *
                             static_cast<double>(height) / static_cast<double>(times.rows));
  }
  return times;
}

double pairs_asked(const scene::ScenePlan& plan) {
  double pairs = 0;
  for (const scene::SpherePlan& sphere : plan.spheres) {
    pairs += static_cast<double>(sphere.pixels.count());
  }
  return pairs;
}

/// The seconds that the exact ray takes for some pixels spread over the image, and the number of
/// these pixels.
std::pair<double, std::uint64_t> time_exact_pixels(const scene::Scene& scene,
                                                   const scene::ScenePlan& plan) {
  constexpr std::uint64_t kMostPixels = 4096;
  constexpr double kAcross = 0.7548776662466927;  // a plane's even spread, as the golden section
  constexpr double kDown = 0.5698402909980532;    // is a line's
  const reference::ExactCamera camera(*scene.camera, plan.conventions);
  const auto place = [](double turns, std::int64_t size) {
    return static_cast<std::int64_t>((turns - std::floor(turns)) * static_cast<double>(size));
  };
  const Clock::time_point start = Clock::now();
  std::uint64_t pixels = 0;
  std::vector<scene::Sphere> spheres;
  do {
    scene::poll();
    const auto turn = static_cast<double>(pixels + 1);
    const scene::Pixel pixel = {place(kAcross * turn, scene.camera->width),
                                place(kDown * turn, scene.camera->height)};
    spheres.clear();
    for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
      if (plan.spheres[k].pixels.contains(pixel)) spheres.push_back(scene.spheres[k]);
    }
    if (!spheres.empty()) {
      const reference::ExactRay ray(camera, pixel);
      if (plan.wanted == Wanted::kClass) {
        for (const scene::Sphere& sphere : spheres) ray.intersect(sphere, plan.conventions.root);
      } else {
        ray.nearest(spheres, plan.conventions);
      }
    }
    ++pixels;
  } while (pixels < kMostPixels && seconds_since(start) < kItemSeconds);
  return {seconds_since(start), pixels};
}

}  // namespace

void time_plan(PlanReport& report) {
  const scene::Scene& scene = report.scene;
  const scene::ScenePlan& plan = *report.plan;
  const Clock::time_point start = Clock::now();
  const auto width = static_cast<double>(scene.camera->width);
  const auto height = static_cast<double>(scene.camera->height);
  const auto spheres = static_cast<double>(scene.spheres.size());
  const Visibility planned(scene, plan);
  const double band = width * Visibility::kBandRows;
  const bool by_rows = band * spheres > kMostPairs || band > kMostPixelsAtATime;
  const Bands bands(scene.camera->height, by_rows ? 1 : Visibility::kBandRows);
  Workload workload(scene, plan.wanted, bands.most_rows());
  const auto time = [&](const std::vector<const Visibility*>& all) {
    return time_parts(all, workload, bands, scene.camera->height);
  };
  const auto pixels_of = [&](const PartTimes& times) {
    return static_cast<std::uint64_t>(times.rows * scene.camera->width);
  };
  const PartTimes times = time({&planned});
  report.image_ms = times.image_ms[0];
  report.pixels_timed = pixels_of(times);
  for (std::size_t k = 0; k < times.bands; ++k) {
    report.decided_by += workload.run(planned, bands[k].first, bands[k].second);
  }
  for (std::size_t k = 0; k < kPlanItems.size(); ++k) {
    if (seconds_since(start) > kAllSeconds) return;
    scene::PlanItems items;
    items.*kPlanItems[k].member = false;
    ItemReport& item = report.items[k];
    if (!items.filter) {
      if (report.decided_by.filter == 0) continue;
      const auto [seconds, pixels] = time_exact_pixels(scene, plan);
      const double all = width * height / static_cast<double>(pixels);
      item.time = PlanTime{*report.image_ms, 1e3 * seconds * all, pixels};
      continue;
    }
    // Hit classes are computed sphere by sphere, with each sphere's constants and without other
    // quantities.
    const bool is_asked = plan.wanted != Wanted::kClass || (items.constants && items.quantities);
    if (item.left_out == 0 || !is_asked) continue;
    const scene::ScenePlan without = scene::plan_scene(scene, plan.conventions, plan.wanted, items);
    const double part_share = static_cast<double>(bands.most_rows()) / height;
    if (pairs_asked(without) * part_share > kMostPairs) continue;
    const Visibility unplanned(scene, without);
    const PartTimes both = time({&planned, &unplanned});
    item.time = PlanTime{both.image_ms[0], both.image_ms[1], pixels_of(both)};
  }
}

}  // namespace raycheck::tools
