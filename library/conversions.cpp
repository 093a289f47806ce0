#include "library/conversions.h"

#include "scene/validate.h"

namespace raycheck::library {

scene::ValidRoots valid_roots(const ValidRoots& v) {
  scene::Conventions conventions;
  conventions.valid = contract::valid_roots(v);
  scene::require_valid(conventions);
  return conventions.valid;
}

scene::Conventions conventions(const Conventions& c) {
  scene::Conventions inside = contract::declared_conventions(c).over(scene::Conventions{});
  inside.valid = valid_roots(c.valid);
  scene::require_valid(inside);
  return inside;
}

Conventions conventions(const scene::Conventions& c) {
  Conventions seen = contract::conventions<Conventions>(c);
  seen.valid = contract::valid_roots<ValidRoots>(c.valid);
  return seen;
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
