// An adapter: calls the functions of a made-up course's assignment "casting" for raycheck.
#include <raycheck/candidate.hpp>

#include "src/sphere.cpp"
#include "src/viewing_ray.cpp"

static Vec own(const raycheck::Vector& v) { return {v.x, v.y, v.z}; }
static raycheck::Vector vector_of(const Vec& v) { return {v.x, v.y, v.z}; }

// The course's cameras look along -z. i is the column, j the row, from the top.
static raycheck::Ray focal_ray(const raycheck::Camera& camera, const raycheck::Conventions&,
                               raycheck::Pixel pixel) {
  const ::Camera theirs = {own(camera.eye), -camera.near_plane, camera.right - camera.left,
                           camera.top - camera.bottom};
  ::Ray ray;
  viewing_ray(theirs, static_cast<int>(pixel.i), static_cast<int>(pixel.j),
              static_cast<int>(camera.width), static_cast<int>(camera.height), ray);
  return {vector_of(ray.origin), vector_of(ray.direction)};
}

static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  const ::Ray theirs = {own(ray.origin), own(ray.direction)};
  double t = 0;
  if (!::Sphere{own(sphere.centre), sphere.radius}.intersect(theirs, 0.001, t)) return {};
  return raycheck::Hit{t, {}};
}

RAYCHECK_CANDIDATE(.focal_ray = focal_ray, .intersect = intersect,
                   .contract =
                       "origin focal; samples centres; rows top-first; windows symmetric; "
                       "made_directions any; returns parameter; t_min 0.001")
