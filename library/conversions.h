#pragma once

// Between the public structs and those that raycheck computes with.

#include <raycheck/scene.h>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/level.h"
#include "scene/scene.h"

namespace raycheck::library {

inline scene::Point3 point(const Vector& v) { return {v.x, v.y, v.z}; }
inline scene::Vector3 vector(const Vector& v) { return {v.x, v.y, v.z}; }
template <class Triple>
Vector vector(const Triple& v) {
  return {v.x, v.y, v.z};
}

inline scene::Ray ray(const Ray& r) { return {point(r.origin), vector(r.direction)}; }
inline Ray ray(const scene::Ray& r) { return {vector(r.origin), vector(r.direction)}; }
inline scene::Sphere sphere(const Sphere& s) { return {point(s.centre), s.radius}; }
inline Sphere sphere(const scene::Sphere& s) { return {vector(s.centre), s.radius}; }
inline scene::Pixel pixel(Pixel p) { return {p.i, p.j}; }
inline Pixel pixel(const scene::Pixel& p) { return {p.i, p.j}; }
scene::Camera camera(const Camera& c);
Camera camera(const scene::Camera& c);

/// as_asked becomes the default.
scene::Conventions conventions(const Conventions& c);
Conventions conventions(const scene::Conventions& c);
/// as_asked stays undeclared.
properties::DeclaredConventions declared(const Conventions& c);
/// Empty where it is not stated.
std::optional<properties::Level> level(Level level);
scene::ValidRoots valid_roots(const ValidRoots& v);
ValidRoots valid_roots(const scene::ValidRoots& v);
scene::Precision precision(Precision precision);

scene::Scene scene_of(const Scene& s);
Scene scene_of(const scene::Scene& s);

}  // namespace raycheck::library
