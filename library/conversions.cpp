#include "library/conversions.h"

#include <optional>

namespace raycheck::library {
namespace {

/// The enumerators that others see are those inside, behind as_asked.
template <class Inside, class Seen>
std::optional<Inside> asked(Seen seen) {
  if (seen == Seen::as_asked) return {};
  return static_cast<Inside>(static_cast<int>(seen) - 1);
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

properties::DeclaredConventions declared(const Conventions& c) {
  return {asked<scene::Rows>(c.rows), asked<scene::Samples>(c.samples),
          asked<scene::Origin>(c.origin), asked<scene::Root>(c.root),
          asked<scene::Tangent>(c.tangent)};
}

scene::Conventions conventions(const Conventions& c) {
  return declared(c).over(scene::Conventions{});
}

Conventions conventions(const scene::Conventions& c) {
  return {seen<Rows>(c.rows), seen<Samples>(c.samples), seen<Origin>(c.origin), seen<Root>(c.root),
          seen<Tangent>(c.tangent)};
}

std::optional<properties::Level> level(Level level) {
  if (level == Level::unstated) return {};
  return static_cast<properties::Level>(static_cast<int>(level) - 1);
}

scene::Precision precision(Precision precision) {
  return precision == Precision::single ? scene::Precision::kSingle : scene::Precision::kDouble;
}

scene::Scene scene_of(const Scene& s) {
  scene::Scene inside;
  if (s.camera) inside.camera = camera(*s.camera);
  for (const Ray& r : s.rays) inside.rays.push_back(ray(r));
  for (const Sphere& one : s.spheres) inside.spheres.push_back(sphere(one));
  inside.conventions = conventions(s.conventions);
  return inside;
}

Scene scene_of(const scene::Scene& s) {
  Scene shown;
  if (s.camera) shown.camera = camera(*s.camera);
  for (const scene::Ray& r : s.rays) shown.rays.push_back(ray(r));
  for (const scene::Sphere& one : s.spheres) shown.spheres.push_back(sphere(one));
  shown.conventions = conventions(s.conventions);
  return shown;
}

}  // namespace raycheck::library
