#pragma once

// Visits the numbers of a scene one by one. Internal to properties/.

#include "scene/scene.h"

namespace raycheck::properties {

/// Calls length(double&) for every number that changes with the unit of length, and other(double&)
/// for `up` and the directions of given rays, which do not; always in the same order. (No formula
/// uses a camera's `far`.)
template <class Length, class Other>
void for_each_length_and_other(scene::Scene& scene, Length& length, Other& other) {
  const auto each = [](auto& triple, auto& visit) {
    visit(triple.x);
    visit(triple.y);
    visit(triple.z);
  };
  if (scene.camera) {
    scene::Camera& camera = *scene.camera;
    each(camera.eye, length);
    each(camera.look_at, length);
    each(camera.up, other);
    for (double* x : {&camera.near, &camera.left, &camera.right, &camera.bottom, &camera.top}) {
      length(*x);
    }
  }
  for (scene::Ray& ray : scene.rays) {
    each(ray.origin, length);
    each(ray.direction, other);
  }
  for (scene::Sphere& sphere : scene.spheres) {
    each(sphere.centre, length);
    length(sphere.radius);
  }
}

template <class Visit>
void for_each_number(scene::Scene& scene, Visit visit) {
  for_each_length_and_other(scene, visit, visit);
}

template <class Visit>
void for_each_length(scene::Scene& scene, Visit visit) {
  const auto ignore = [](double&) {};
  for_each_length_and_other(scene, visit, ignore);
}

}  // namespace raycheck::properties
