#include "library/conversions.h"

#include <fmt/core.h>

#include <optional>
#include <stdexcept>
#include <string_view>

#include "scene/validate.h"

namespace raycheck::library {

int require_one_of(int place, std::size_t count, std::string_view field) {
  if (place >= 0 && static_cast<std::size_t>(place) < count) return place;
  throw std::invalid_argument(
      fmt::format("{} = {}: not one of its {} enumerators", field, place, count));
}

namespace {

template <class Seen>
int place_of(Seen seen, std::size_t count, std::string_view field) {
  return require_one_of(static_cast<int>(seen), count, field);
}

/// The public enumerators are as_asked and then the internal enumerators, in the same order.
template <class Inside, class Seen, class Names>
std::optional<Inside> asked(Seen seen, const Names& names, std::string_view field) {
  const int place = place_of(seen, names.size() + 1, field);
  if (place == 0) return {};
  return static_cast<Inside>(place - 1);
}

template <class Seen, class Inside>
Seen seen(Inside inside) {
  return static_cast<Seen>(static_cast<int>(inside) + 1);
}

}  // namespace

scene::Camera camera(const Camera& c) {
  return {point(c.eye), point(c.look_at), vector(c.up), c.near_plane, {},      c.left,
          c.right,      c.bottom,         c.top,        c.width,      c.height};
}

Camera camera(const scene::Camera& c) {
  return {vector(c.eye), vector(c.look_at), vector(c.up), c.near,  c.left,
          c.right,       c.bottom,          c.top,        c.width, c.height};
}

scene::ValidRoots valid_roots(const ValidRoots& v) {
  const auto ends = place_of(v.ends, scene::kEndsNames.size(), "valid.ends");
  const auto unit = place_of(v.unit, scene::kTUnitNames.size(), "valid.unit");
  const auto culling = place_of(v.culling, scene::kCullingNames.size(), "valid.culling");
  scene::Conventions conventions;
  conventions.valid = {v.t_min, v.t_max, static_cast<scene::Ends>(ends),
                       static_cast<scene::TUnit>(unit), static_cast<scene::Culling>(culling)};
  scene::require_valid(conventions);
  return conventions.valid;
}

ValidRoots valid_roots(const scene::ValidRoots& v) {
  return {v.t_min, v.t_max, static_cast<Ends>(v.ends), static_cast<TUnit>(v.unit),
          static_cast<Culling>(v.culling)};
}

properties::DeclaredConventions declared(const Conventions& c) {
  return {asked<scene::Rows>(c.rows, scene::kRowsNames, "rows"),
          asked<scene::Samples>(c.samples, scene::kSamplesNames, "samples"),
          asked<scene::Origin>(c.origin, scene::kOriginNames, "origin"),
          asked<scene::Root>(c.root, scene::kRootNames, "root"),
          asked<scene::Tangent>(c.tangent, scene::kTangentNames, "tangent"),
          {}};
}

scene::Conventions conventions(const Conventions& c) {
  scene::Conventions inside = declared(c).over(scene::Conventions{});
  inside.valid = valid_roots(c.valid);
  scene::require_valid(inside);
  return inside;
}

Conventions conventions(const scene::Conventions& c) {
  return {seen<Rows>(c.rows), seen<Samples>(c.samples), seen<Origin>(c.origin),
          seen<Root>(c.root), seen<Tangent>(c.tangent), valid_roots(c.valid)};
}

std::optional<properties::Level> level(Level level) {
  return asked<properties::Level>(level, properties::kLevelNames, "level");
}

scene::Precision precision(Precision precision) {
  return precision == Precision::single ? scene::Precision::kSingle : scene::Precision::kDouble;
}

scene::Scene scene_of(const Scene& s) {
  scene::Scene inside;
  if (s.camera) inside.camera = camera(*s.camera);
  for (const Ray& r : s.rays) inside.rays.push_back(ray(r));
  inside.spheres = spheres(s.spheres);
  inside.conventions = conventions(s.conventions);
  return inside;
}

Scene scene_of(const scene::Scene& s) {
  Scene shown;
  if (s.camera) shown.camera = camera(*s.camera);
  for (const scene::Ray& r : s.rays) shown.rays.push_back(ray(r));
  shown.spheres = spheres(s.spheres);
  shown.conventions = conventions(s.conventions);
  return shown;
}

properties::Case case_of(const Case& the_case) {
  properties::Case made{scene_of(the_case.scene), {}};
  scene::require_valid(made.scene);
  for (const Pixel& one : the_case.pixels) made.pixels.push_back(pixel(one));
  return made;
}

Case case_of(const properties::Case& the_case) {
  Case made{scene_of(the_case.scene), {}};
  for (const scene::Pixel& one : the_case.pixels) made.pixels.push_back(pixel(one));
  return made;
}

}  // namespace raycheck::library
