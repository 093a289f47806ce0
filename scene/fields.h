#pragma once

// The fields of a scene, with their names and in their order in files.

#include <concepts>
#include <type_traits>

#include "scene/scene.h"

namespace raycheck::scene {

template <class T, class Plain>
concept Either = std::same_as<std::remove_const_t<T>, Plain>;

/// Calls visit(name, field) for every field of a camera; the overloads below do so for others.
template <Either<Camera> ACamera, class Visit>
void for_each_field(ACamera& camera, Visit visit) {
  visit("eye", camera.eye);
  visit("look_at", camera.look_at);
  visit("up", camera.up);
  visit("near", camera.near);
  visit("far", camera.far);
  visit("left", camera.left);
  visit("right", camera.right);
  visit("bottom", camera.bottom);
  visit("top", camera.top);
  visit("width", camera.width);
  visit("height", camera.height);
}
template <Either<Sphere> ASphere, class Visit>
void for_each_field(ASphere& sphere, Visit visit) {
  visit("centre", sphere.centre);
  visit("radius", sphere.radius);
}
template <Either<Ray> ARay, class Visit>
void for_each_field(ARay& ray, Visit visit) {
  visit("origin", ray.origin);
  visit("direction", ray.direction);
}
template <Either<ValidRoots> AValidRoots, class Visit>
void for_each_field(AValidRoots& valid, Visit visit) {
  visit("t_min", valid.t_min);
  visit("t_max", valid.t_max);
  visit("interval", valid.ends);
  visit("t_unit", valid.unit);
  visit("culling", valid.culling);
}
/// Calls visit(name, field) for every choice in conventions except the valid roots. The choices may
/// be optional, as in a candidate's declarations.
template <class SomeConventions, class Visit>
void for_each_choice(SomeConventions& conventions, Visit visit) {
  visit("rows", conventions.rows);
  visit("samples", conventions.samples);
  visit("origin", conventions.origin);
  visit("root", conventions.root);
  visit("tangent", conventions.tangent);
}

/// Calls length(double&) for every length and coordinate of a point, and other(double&) for the
/// coordinates of `up` and of given directions, which do not depend on the unit of length. The
/// order is fixed. A camera's `far`, which no formula uses, is left out.
template <class Length, class Other>
void for_each_length_and_other(Scene& scene, Length& length, Other& other) {
  const auto each = [](auto& triple, auto& number) {
    number(triple.x);
    number(triple.y);
    number(triple.z);
  };
  const auto visit = [&](const char* /*name*/, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    if constexpr (std::same_as<Field, Point3>) each(field, length);
    if constexpr (std::same_as<Field, Vector3>) each(field, other);
    if constexpr (std::same_as<Field, double>) length(field);
  };
  if (scene.camera) for_each_field(*scene.camera, visit);
  for (Ray& ray : scene.rays) for_each_field(ray, visit);
  for (Sphere& sphere : scene.spheres) for_each_field(sphere, visit);
}

template <class Visit>
void for_each_number(Scene& scene, Visit visit) {
  for_each_length_and_other(scene, visit, visit);
}

template <class Visit>
void for_each_length(Scene& scene, Visit visit) {
  const auto ignore = [](double&) {};
  for_each_length_and_other(scene, visit, ignore);
}

}  // namespace raycheck::scene
