#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "fast/intersect.h"
#include "properties/case.h"
#include "properties/mistakes/mistake_list.h"
#include "properties/mistakes/picture_causes.h"

namespace raycheck::properties {
namespace {

/// Whether there is a ray that misses all spheres although its line meets one.
bool has_ray_with_all_behind(const Scene& scene) {
  const auto rays = right_candidate().rays_from(scene.conventions.origin)(
      *scene.camera, scene.conventions, all_pixels(*scene.camera));
  return std::any_of(rays.begin(), rays.end(), [&](const Ray& ray) {
    bool is_behind = false;
    for (const Sphere& sphere : scene.spheres) {
      const fast::Roots roots = fast::kCross.roots(ray, sphere);
      if (!(roots.half_chord_sq >= 0)) continue;
      if (roots.larger >= 0) return false;
      is_behind = true;
    }
    return is_behind;
  });
}

bool are_whole(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return x == std::trunc(x); });
}
bool are_whole(const auto& triple) { return are_whole({triple.x, triple.y, triple.z}); }

bool has_fractions_in_view(const Scene& s) {
  const Camera& its = *s.camera;
  return !(are_whole(its.eye) && are_whole(its.look_at) && are_whole(its.up));
}
bool has_fraction_in_near(const Scene& s) { return !are_whole({s.camera->near}); }
bool has_fractions_in_bounds(const Scene& s) {
  const Camera& its = *s.camera;
  return !are_whole({its.left, its.right, its.bottom, its.top});
}
bool has_fractions_in_spheres(const Scene& s) {
  return std::any_of(s.spheres.begin(), s.spheres.end(), [](const Sphere& its) {
    return !(are_whole(its.centre) && are_whole({its.radius}));
  });
}
bool has_fractions(const Scene& s) {
  return has_fractions_in_view(s) || has_fraction_in_near(s) || has_fractions_in_bounds(s) ||
         has_fractions_in_spheres(s);
}

struct Shape {
  const char* where;
  bool (*is)(const Scene&);
  bool is_part = false;  ///< A special case of the last shape above that is not a part of it.
};

bool is_uneven_across(const Scene& s) { return s.camera->left != -s.camera->right; }
bool is_uneven_upwards(const Scene& s) { return s.camera->bottom != -s.camera->top; }

constexpr Shape kShapes[] = {
    {"the picture is not square",
     [](const Scene& s) { return s.camera->width != s.camera->height; }},
    {"the picture is square", [](const Scene& s) { return s.camera->width == s.camera->height; }},
    {"the picture is wider than high",
     [](const Scene& s) { return s.camera->width > s.camera->height; }},
    {"the picture is higher than wide",
     [](const Scene& s) { return s.camera->width < s.camera->height; }},
    {"the picture has one column", [](const Scene& s) { return s.camera->width == 1; }},
    {"the picture has one row", [](const Scene& s) { return s.camera->height == 1; }},
    {"the bounds are not symmetric",
     [](const Scene& s) { return is_uneven_across(s) || is_uneven_upwards(s); }},
    {"left is not -right", is_uneven_across, true},
    {"bottom is not -top", is_uneven_upwards, true},
    {"left is not -right and bottom is not -top",
     [](const Scene& s) { return is_uneven_across(s) && is_uneven_upwards(s); }, true},
    {"the eye is not at the origin", [](const Scene& s) { return !(s.camera->eye == Point3{}); }},
    {"everything that a ray's line meets is behind the ray's origin", has_ray_with_all_behind},
    {"some number has a fraction", has_fractions},
    {"eye, look or up has a fraction", has_fractions_in_view, true},
    {"d has a fraction", has_fraction_in_near, true},
    {"a bound has a fraction", has_fractions_in_bounds, true},
    {"a sphere has a fraction", has_fractions_in_spheres, true},
    {"there are several spheres", [](const Scene& s) { return s.spheres.size() > 1; }},
    {"there is one sphere", [](const Scene& s) { return s.spheres.size() == 1; }},
    {"there is no sphere", [](const Scene& s) { return s.spheres.empty(); }},
};

}  // namespace

std::optional<ShapeCause> shape_cause(std::span<const TriedScene> tried) {
  const auto failed = static_cast<std::size_t>(
      std::count_if(tried.begin(), tried.end(), [](const auto& one) { return one.failed; }));
  if (std::min(failed, tried.size() - failed) < kFewestOfEachOutcome) return {};
  std::optional<ShapeCause> cause;
  bool whole_tells = false;
  for (const auto& [where, is, is_part] : kShapes) {
    if (is_part && whole_tells) continue;
    const bool tells = std::all_of(tried.begin(), tried.end(), [is = is](const TriedScene& one) {
      return is(*one.scene) == one.failed;
    });
    if (!is_part) whole_tells = tells;
    if (!tells) continue;
    if (cause) return {};
    cause = ShapeCause{"it fails only if " + std::string(where), is};
  }
  return cause;
}

}  // namespace raycheck::properties
