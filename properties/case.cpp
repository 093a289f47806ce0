#include "properties/case.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "scene/fields.h"
#include "scene/number.h"
#include "scene/validate.h"

namespace raycheck::properties {

std::size_t count_rays(const Case& the_case) {
  return the_case.scene.camera ? the_case.pixels.size() : the_case.scene.rays.size();
}

std::vector<scene::Pixel> all_pixels(const scene::Camera& camera) {
  std::vector<scene::Pixel> pixels;
  pixels.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (std::int64_t j = 0; j < camera.height; ++j) {
    for (std::int64_t i = 0; i < camera.width; ++i) pixels.push_back({i, j});
  }
  return pixels;
}

using scene::Precision;

RoundedCase rounded_case(Case the_case, Precision precision) {
  RoundedCase result;
  if (precision == Precision::kDouble) {
    result.the_case = std::move(the_case);
    return result;
  }
  const auto round = [&](double& x) {
    const double rounded = scene::rounded_to(precision, x);
    if (rounded == x) return;
    ++result.changed;
    const bool is_lost = !std::isfinite(rounded) || rounded == 0;
    if (is_lost && result.reason.empty()) {
      result.reason = "rounded to floats: " + scene::shortest(x) + " leaves their range";
    }
    x = rounded;
  };
  for_each_number(the_case.scene, round);
  scene::ValidRoots& valid = the_case.scene.conventions.valid;
  round(valid.t_min);
  round(valid.t_max);
  if (the_case.scene.camera) the_case.scene.camera->far.reset();
  if (!result.reason.empty()) return result;
  const auto defects = scene::defects(the_case.scene);
  if (!defects.empty()) {
    result.reason = "rounded to floats: " + defects.front().field + " = " + defects.front().value +
                    ": " + defects.front().what;
    return result;
  }
  result.the_case = std::move(the_case);
  return result;
}

scene::Ray rounded_ray(scene::Ray ray, Precision precision) {
  for (double* x : {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x, &ray.direction.y,
                    &ray.direction.z}) {
    *x = scene::rounded_to(precision, *x);
  }
  return ray;
}

bool is_of_format(const scene::Scene& scene, Precision precision) {
  if (precision == Precision::kDouble) return true;
  bool all = true;
  scene::Scene copy = scene;
  const auto look = [&](const double& x) { all = all && scene::rounded_to(precision, x) == x; };
  for_each_number(copy, look);
  look(scene.conventions.valid.t_min);
  look(scene.conventions.valid.t_max);
  return all;
}

}  // namespace raycheck::properties
