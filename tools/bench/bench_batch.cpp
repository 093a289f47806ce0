// The functions of raycheck/batch.h, each in pairs with what it is measured against: the two run in
// turn, and the median of the ratios of their times counts. Items are rays. Answers are compared
// with the exact ray before anything is timed.
//   --target=NAME   is taken by choose_target
//   NAME            only pairs whose names begin so

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <raycheck/batch.hpp>
#include <string>
#include <vector>

#include "properties/cases/case_source.h"
#include "reference/exact_ray.h"
#include "reference/visibility/visibility.h"
#include "tools/bench/bench_scenes.h"

namespace {

using namespace raycheck;

using Action = std::function<void()>;

std::string asked_name;

double seconds(const Action& work, int times) {
  const auto now = [] { return std::chrono::steady_clock::now().time_since_epoch(); };
  const auto start = now();
  for (int k = 0; k < times; ++k) work();
  return std::chrono::duration<double>(now() - start).count();
}

/// The middle of the times for one item, and of the ratios to the other's.
void pair(const char* name, std::size_t items, const Action& work, const char* other_name,
          std::size_t other_items, const Action& other) {
  if (!std::string_view(name).starts_with(asked_name)) return;
  constexpr int kRounds = 31;
  constexpr double kRound = 0.02;
  const auto times_of = [&](const Action& one) {
    one();
    return 1 + static_cast<int>(kRound / seconds(one, 1));
  };
  const int times = times_of(work), other_times = times_of(other);
  std::vector<double> all, ratios;
  for (int round = 0; round < kRounds; ++round) {
    const double its = seconds(work, times) / times / static_cast<double>(items);
    const double others =
        seconds(other, other_times) / other_times / static_cast<double>(other_items);
    all.push_back(its);
    ratios.push_back(others / its);
  }
  const auto middle = [](std::vector<double>& x) {
    std::nth_element(x.begin(), x.begin() + kRounds / 2, x.end());
    return x[kRounds / 2];
  };
  const double time = middle(all);
  std::printf("%-38s %8.2f ns %8.1f M/s   %6.3f times the speed of %s\n", name, 1e9 * time,
              1e-6 / time, middle(ratios), other_name);
}

struct Rays {
  fast::Rays rays;
  fast::Vectors centres;
  std::vector<double> radii;
  std::vector<std::uint8_t> classes, roots;
  std::vector<double> s, s_error;
  fast::Vectors point, point_error;
  raycheck_rays given;
  raycheck_spheres spheres;

  static raycheck_array3 in(const fast::Vectors& v) { return batch::array(v.x, v.y, v.z); }
  static raycheck_output3 out(fast::Vectors& v) { return batch::output(v.x, v.y, v.z); }

  Rays(fast::Rays its_rays, const std::vector<scene::Sphere>& its_spheres)
      : rays(std::move(its_rays)),
        classes(rays.size()),
        roots(rays.size()),
        s(rays.size()),
        s_error(rays.size()),
        given(),
        spheres() {
    for (fast::Vectors* one : {&point, &point_error}) one->resize(rays.size());
    centres.resize(its_spheres.size());
    for (std::size_t k = 0; k < its_spheres.size(); ++k) {
      centres.set(k, its_spheres[k].centre);
      radii.push_back(its_spheres[k].radius);
    }
    given.origin = in(rays.origin);
    given.direction = in(rays.direction);
    spheres = {in(centres), batch::array(radii)};
  }

  raycheck_decided answers(bool with_bounds) {
    return {batch::output(classes),
            batch::output(roots),
            batch::output(s),
            out(point),
            with_bounds ? batch::output(s_error) : raycheck_output{},
            with_bounds ? out(point_error) : raycheck_output3{}};
  }
  Action decide(bool with_bounds, int threads = 1) {
    return [this, with_bounds, threads] {
      const raycheck_options options = batch::options(threads);
      const raycheck_decided to = answers(with_bounds);
      batch::check(raycheck_decide(&given, &spheres, &options, &to, &batch::error()));
    };
  }
  /// Whether the classes are those of the exact ray.
  bool is_right() {
    decide(true)();
    for (std::size_t k = 0; k < std::min<std::size_t>(4000, rays.size()); ++k) {
      const std::size_t m = radii.size() == 1 ? 0 : k;
      const auto at = reference::ExactRay(rays.at(k))
                          .intersect({centres.at<scene::Point3>(m), radii[m]},
                                     scene::Root::kNearest, {reference::Engine::kFieldOnly});
      if (classes[k] != static_cast<std::uint8_t>(at.hit_class)) return false;
    }
    return true;
  }
};

/// Rays and spheres of all sources of given rays, and of all severities.
Rays of_families() {
  constexpr int kCases = 10;
  std::vector<scene::Ray> rays;
  std::vector<scene::Sphere> spheres;
  for (const properties::CaseSource& source : properties::case_sources()) {
    if (source.has_camera || !source.severities) continue;
    for (int severity = 0; severity <= source.severities->highest; ++severity) {
      for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        const auto made = properties::ChosenSource{&source, severity}.make(seed);
        rays.push_back(made.scene.rays.front());
        spheres.push_back(made.scene.spheres.front());
      }
    }
  }
  fast::Rays arrays;
  arrays.resize(rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k) arrays.set(k, rays[k]);
  return {arrays, spheres};
}

}  // namespace

int main(int argc, char** argv) {
  if (!tools::choose_target(argc, argv)) return 2;
  if (argc > 1) asked_name = argv[1];
  const scene::Scene scene = tools::unrelated_rays();
  const scene::Sphere& sphere = scene.spheres.front();
  Rays one(tools::rays_of(scene), {sphere});
  std::vector<scene::Sphere> own;
  for (std::size_t k = 0; k < one.rays.size(); ++k) {
    own.push_back(sphere);
    own.back().radius *= 1 + 1e-3 * static_cast<double>(k % 7);
    own.back().centre.x += 1e-3 * static_cast<double>(k % 5);
  }
  Rays each(one.rays, own);
  const std::size_t count = one.rays.size();
  Rays hard = of_families();
  if (!one.is_right() || !each.is_right() || !hard.is_right()) {
    std::fprintf(stderr, "classes are wrong\n");
    return 1;
  }
  fast::Hits hits;
  const auto by = [&](const fast::IntersectMethod& method, const fast::Rays& rays) {
    return [&] { method.intersect(rays, sphere, {}, hits); };
  };
  const char* const quadratic = "quadratic";
  pair("robust", count, by(fast::kRobust, one.rays), quadratic, count,
       by(fast::kQuadratic, one.rays));
  pair("decide, one sphere", count, one.decide(false), quadratic, count,
       by(fast::kQuadratic, one.rays));
  pair("decide with bounds, one sphere", count, one.decide(true), quadratic, count,
       by(fast::kQuadratic, one.rays));
  pair("decide, N spheres", count, each.decide(false), quadratic, count,
       by(fast::kQuadratic, one.rays));
  pair("decide with bounds, N spheres", count, each.decide(true), quadratic, count,
       by(fast::kQuadratic, one.rays));
  std::vector<double> s_ulp(count), point_u(count);
  std::vector<std::uint8_t> wrong(count);
  const raycheck_answers answers = {batch::array(one.classes), batch::array(one.s),
                                    Rays::in(one.point)};
  const auto error_of = [&](bool with_points, int threads) {
    return [&, with_points, threads] {
      raycheck_errors to = {};
      to.hit_class = batch::output(wrong);
      to.s_ulp = batch::output(s_ulp);
      if (with_points) to.point_u = batch::output(point_u);
      const raycheck_options options = batch::options(threads);
      batch::check(
          raycheck_error_of(&one.given, &one.spheres, &options, &answers, &to, &batch::error()));
    };
  };
  one.decide(true)();
  pair("error_of, class and s", count, error_of(false, 1), quadratic, count,
       by(fast::kQuadratic, one.rays));
  pair("error_of, class, s and Q", count, error_of(true, 1), quadratic, count,
       by(fast::kQuadratic, one.rays));
  for (const std::int64_t spheres : {100, 10'000}) {
    const scene::Scene seen = tools::in_view(spheres);
    const std::string name = "image of " + std::to_string(spheres) + " spheres";
    const reference::Visibility visibility(
        seen, scene::plan_scene(seen, seen.conventions, scene::Wanted::kNearest));
    const Rays balls(fast::Rays{}, seen.spheres);
    const scene::Camera& c = *seen.camera;
    const auto triple = [](const auto& v) { return raycheck_vector{v.x, v.y, v.z}; };
    const raycheck_camera camera = {triple(c.eye), triple(c.look_at), triple(c.up), c.near,
                                    c.left,        c.right,           c.bottom,     c.top,
                                    c.width,       c.height};
    const auto pixels = static_cast<std::size_t>(c.width * c.height);
    std::vector<std::int32_t> seen_sphere(pixels), others(pixels);
    std::vector<double> s(pixels);
    const raycheck_options options = batch::options();
    raycheck_seen to = {};
    to.sphere = batch::output(seen_sphere);
    to.s = batch::output(s);
    const Action draw = [&] {
      batch::check(raycheck_image(&camera, &balls.spheres, &options, &to, &batch::error()));
    };
    const Action see = [&] {
      const reference::Visibility made(
          seen, scene::plan_scene(seen, seen.conventions, scene::Wanted::kNearest));
      made.nearest(0, c.height, {others, s, {}, {}, {}});
    };
    draw();
    see();
    if (seen_sphere != others) return 1;
    pair(name.c_str(), pixels, draw, "plan and Visibility", pixels, see);
  }
  // Blocks of many rays, by one thread and by two.
  constexpr std::size_t kMany = 4'000'003;
  fast::Rays repeated;
  repeated.resize(kMany);
  for (std::size_t k = 0; k < kMany; ++k) repeated.set(k, one.rays.at(k % count));
  Rays many(std::move(repeated), {sphere});
  pair("decide with bounds, two threads", kMany, many.decide(true, 2), "one thread", kMany,
       many.decide(true, 1));
  pair("decide, families and severities", hard.rays.size(), hard.decide(false), quadratic, count,
       by(fast::kQuadratic, one.rays));
  return 0;
}
