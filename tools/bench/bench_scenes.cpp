#include "tools/bench/bench_scenes.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <optional>

#include "fast/camera_frame.h"
#include "properties/candidates/fast_candidate.h"
#include "properties/cases/random.h"
#include "properties/laws/law.h"
#include "reference/exact_ray.h"

namespace raycheck::tools {
namespace {

double between(std::uint64_t& state, double low, double high) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return low + static_cast<double>(state >> 11) * 0x1p-53 * (high - low);
}

}  // namespace

scene::Scene camera_of(std::int64_t width, std::int64_t height) {
  scene::Scene scene;
  scene.camera = scene::Camera{
      {1.3, 2.7, 9.1}, {0.2, 0.1, -3}, {0.1, 1, 0.3}, -1, std::nullopt, -0.8, 0.8, -0.8, 0.8,
      width,           height};
  return scene;
}

scene::Scene scene_in_view() {
  scene::Scene scene = camera_of(64, 64);
  scene.spheres = {kBenchSphere};
  return scene;
}

scene::Scene in_view(std::int64_t spheres, std::int64_t size) {
  scene::Scene scene = camera_of(size, size);
  const auto [U, V, W] = fast::camera_frame(*scene.camera);
  const scene::Point3& E = scene.camera->eye;
  properties::Random random(static_cast<std::uint64_t>(spheres) + 1);
  for (std::int64_t k = 0; k < spheres; ++k) {
    const double depth = random.between(5, 60);
    const double u = 0.8 * depth * random.between(-1, 1);
    const double v = 0.8 * depth * random.between(-1, 1);
    scene.spheres.push_back(
        {{E.x - depth * W.x + u * U.x + v * V.x, E.y - depth * W.y + u * U.y + v * V.y,
          E.z - depth * W.z + u * U.z + v * V.z},
         random.between(0.2, 1)});
  }
  return scene;
}

namespace {

constexpr std::int64_t kSide = 1024;

/// A row of pixels. The plane of its rays passes the sphere's surface at a distance of `above`
/// radii; if that is 0, all rays of an upright camera are exactly tangent.
scene::Scene tangent_row(double above, const scene::Point3& look_at = {0, 0, -1}) {
  scene::Scene scene;
  scene.camera = scene::Camera{{0, 0, 0}, look_at, {0, 1, 0},     -1, std::nullopt, -0.75, 0.75,
                               -0.5,      0.5,     kSide * kSide, 1};
  const scene::UnitVector3 V = fast::camera_frame(*scene.camera).V;
  scene.spheres = {{{-2 * V.x, -2 * V.y, -2 * V.z}, 2 * (1 - above)}};
  scene.conventions.origin = scene::Origin::kFocal;
  scene.conventions.samples = scene::Samples::kCentres;
  return scene;
}

/// A row of exactly tangent rays whose positions are not double-doubles.
scene::Scene tangent_by_edges() {
  scene::Scene scene = tangent_row(0);
  scene.camera->bottom = 0;
  scene.camera->height = 2;
  scene.camera->width /= 2;
  scene.conventions.samples = scene::Samples::kEdges;
  return scene;
}

/// A hundred spheres in view, moved along x.
scene::Scene moved(double x) {
  scene::Scene scene = in_view(100);
  scene.camera->eye.x += x;
  scene.camera->look_at.x += x;
  for (scene::Sphere& sphere : scene.spheres) sphere.centre.x += x;
  return scene;
}

/// The hundred spheres, seen through a narrow window from a distance larger by this factor.
scene::Scene from_afar(double times) {
  scene::Scene scene = in_view(100);
  scene::Camera& camera = *scene.camera;
  const scene::Vector3 back = camera.eye - camera.look_at;
  camera.eye = {camera.look_at.x + times * back.x, camera.look_at.y + times * back.y,
                camera.look_at.z + times * back.z};
  for (double* edge : {&camera.left, &camera.right, &camera.bottom, &camera.top}) *edge /= times;
  return scene;
}

}  // namespace

std::vector<HardScene> hard_scenes() {
  std::vector<HardScene> scenes = {{"tangent", tangent_row(0)},
                                   {"tangent-edges", tangent_by_edges()},
                                   {"near-tangent", tangent_row(-1e-12)},
                                   {"tilted", tangent_row(-1e-12, {1, -2, -3})},
                                   {"at-origin", moved(0)},
                                   {"far-world", moved(1e7)},
                                   {"near-camera", from_afar(4)},
                                   {"far-camera", from_afar(1e7)},
                                   {"distinct", in_view(1000)}};
  scene::Scene equal = in_view(1), nested = equal;
  for (int k = 1; k < 1000; ++k) {
    equal.spheres.push_back(equal.spheres.front());
    nested.spheres.push_back({equal.spheres.front().centre, 1 - 0x1p-11 * k});
  }
  scenes.push_back({"one", in_view(1)});
  scenes.push_back({"equal", equal});
  scenes.push_back({"nested", nested});
  return scenes;
}

scene::Scene unrelated_rays() {
  // With a multiple of 512, loads from one array would wait for stores to another at the same
  // address modulo 4096.
  constexpr int kRays = 4000;
  scene::Scene scene;
  scene.spheres = {kBenchSphere};
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

fast::Rays rays_of(const scene::Scene& scene) {
  fast::Rays rays;
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

std::vector<scene::Pixel> scattered_pixels(std::int64_t side) {
  std::vector<scene::Pixel> result;
  std::uint64_t state = 1;
  for (int k = 0; k < 1 << 14; ++k) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    result.push_back({static_cast<std::int64_t>(state >> 33) % side,
                      static_cast<std::int64_t>(state >> 45) % side});
  }
  return result;
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

std::string wrong_answers(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect,
                          const scene::Scene& scene) {
  properties::Case the_case{scene, {}};
  if (scene.camera) the_case.pixels = properties::all_pixels(*scene.camera);
  const properties::Candidate candidate = properties::fast_candidate(rays, intersect);
  properties::Trial trial(the_case, candidate);
  for (const properties::Law& law : properties::laws()) {
    if (!law.judges_values || !law.tells_stability) continue;
    // Some of the rays graze; for these, less stable methods exceed their bounds.
    if (law.quantity == properties::Quantity::kParameter && !intersect.not_kept.empty()) continue;
    if (!apply(law, trial).holds()) {
      return candidate.name + " breaks the law " + std::string(law.name);
    }
  }
  return {};
}

bool choose_target(int& argc, char** argv, std::string_view otherwise) {
  constexpr std::string_view kOption = "--target=";
  std::string_view name = otherwise;
  char** const option = std::find_if(
      argv, argv + argc, [&](std::string_view argument) { return argument.starts_with(kOption); });
  if (option != argv + argc) {
    name = std::string_view(*option).substr(kOption.size());
    std::copy(option + 1, argv + argc + 1, option);
    --argc;
  }
  if (name.empty()) return true;
  const auto targets = hwy::SupportedAndGeneratedTargets();
  for (const std::int64_t target : targets) {
    if (name != hwy::TargetName(target)) continue;
    hwy::SetSupportedTargetsForTest(target);
    return true;
  }
  std::cerr << kOption << name << ": this machine has";
  for (const std::int64_t target : targets) std::cerr << " " << hwy::TargetName(target);
  std::cerr << "\n";
  return false;
}

}  // namespace raycheck::tools
