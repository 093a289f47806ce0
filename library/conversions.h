#pragma once

// Converts the public structs to the internal ones and back.

#include <raycheck/judge.h>

#include <span>
#include <vector>

#include "contract/public_structs.h"
#include "properties/candidate.h"
#include "properties/case.h"
#include "scene/scene.h"

namespace raycheck::library {

inline scene::Point3 point(const Vector& v) { return {v.x, v.y, v.z}; }
inline scene::Vector3 vector(const Vector& v) { return {v.x, v.y, v.z}; }
template <class Triple>
Vector vector(const Triple& v) {
  return {v.x, v.y, v.z};
}

inline scene::Ray ray(const Ray& r) { return contract::ray<scene::Ray>(r); }
inline Ray ray(const scene::Ray& r) { return contract::ray<Ray>(r); }
inline scene::Sphere sphere(const Sphere& s) { return contract::sphere<scene::Sphere>(s); }
inline Sphere sphere(const scene::Sphere& s) { return contract::sphere<Sphere>(s); }
inline scene::Pixel pixel(Pixel p) { return {p.i, p.j}; }
inline Pixel pixel(const scene::Pixel& p) { return {p.i, p.j}; }
inline std::vector<scene::Sphere> spheres(const std::vector<Sphere>& list) {
  std::vector<scene::Sphere> all;
  for (const Sphere& one : list) all.push_back(sphere(one));
  return all;
}
inline std::vector<Sphere> spheres(std::span<const scene::Sphere> list) {
  std::vector<Sphere> all;
  for (const scene::Sphere& one : list) all.push_back(sphere(one));
  return all;
}
inline scene::Camera camera(const Camera& c) { return contract::camera(c); }
inline Camera camera(const scene::Camera& c) { return contract::camera<Camera>(c); }

/// Internal conventions; as_asked becomes the default.
scene::Conventions conventions(const Conventions& c);
Conventions conventions(const scene::Conventions& c);
/// Errors: std::invalid_argument where it is not an interval.
scene::ValidRoots valid_roots(const ValidRoots& v);

scene::Scene scene_of(const Scene& s);
Scene scene_of(const scene::Scene& s);

/// The internal case. Errors: std::invalid_argument if the scene is not valid or a pixel lies
/// outside its image.
properties::Case case_of(const Case& the_case);
Case case_of(const properties::Case& the_case);

/// The internal candidate, judged by the bounds of direct/cross; its `intersect` is replaced by
/// `batch` if that is not null. Both must live as long as it. Errors: std::invalid_argument naming
/// what is invalid.
properties::Candidate inside(const Candidate& candidate, const IntersectBatch* batch = nullptr);

}  // namespace raycheck::library
