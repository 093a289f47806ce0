#ifndef RAYCHECK_CANDIDATE_HPP_
#define RAYCHECK_CANDIDATE_HPP_

// Plain functions on plain structs as a candidate (`--candidate source:FILE.cpp`):
//
//     #include <raycheck/candidate.hpp>
//     using namespace raycheck;
//
//     Ray pixel_ray(const Camera& camera, const Conventions&, Pixel pixel) { ... }
//     std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) { ...
//     }
//
//     RAYCHECK_CANDIDATE(.pixel_ray = pixel_ray, .intersect = intersect)
//
// <raycheck/candidate.h> says what each function must do. Declare the conventions that yours fix:
// RAYCHECK_CANDIDATE(.rows = Rows::top_first, .pixel_ray = pixel_ray). Name members in the order of
// Functions. C++20.

#include <raycheck/candidate.h>
#include <raycheck/scene.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace raycheck {

/// A candidate: what it declares, and its functions; null: it lacks that function.
struct Functions {
  const char* name = nullptr;
  Rows rows = Rows::as_asked;
  Samples samples = Samples::as_asked;
  Origin origin = Origin::as_asked;
  Root root = Root::as_asked;
  Tangent tangent = Tangent::as_asked;
  Frame (*frame)(const Camera&) = nullptr;
  Vector (*pixel_point)(const Camera&, const Conventions&, Pixel) = nullptr;
  Ray (*pixel_ray)(const Camera&, const Conventions&, Pixel) = nullptr;
  Ray (*focal_ray)(const Camera&, const Conventions&, Pixel) = nullptr;
  std::optional<Hit> (*intersect)(const Ray&, const Sphere&, const Conventions&) = nullptr;
  std::optional<std::size_t> (*nearest)(const Ray&, const std::vector<Sphere>&,
                                        const Conventions&) = nullptr;
  Level level = Level::unstated;
  /// Scenes with a nonzero length that is smaller or larger are not judged; both 0: all are.
  double smallest_length = 0, largest_length = 0;
  /// For single: all inputs are floats, passed as doubles, and errors count u and ulp of float.
  Precision precision = Precision::double_;
  Roots roots = Roots::usual;
  ValidRoots valid = {};  ///< For Roots::declared.
};

namespace detail {

inline Functions functions;

inline Vector from_c(const raycheck_vector& v) { return {v.x, v.y, v.z}; }
inline raycheck_vector to_c(const Vector& v) { return {v.x, v.y, v.z}; }
inline Camera from_c(const raycheck_camera& c) {
  return {from_c(c.eye), from_c(c.look_at), from_c(c.up), c.near_plane, c.left,
          c.right,       c.bottom,          c.top,        c.width,      c.height};
}
inline Ray from_c(const raycheck_ray& ray) { return {from_c(ray.origin), from_c(ray.direction)}; }
inline raycheck_ray to_c(const Ray& ray) { return {to_c(ray.origin), to_c(ray.direction)}; }
inline Sphere from_c(const raycheck_sphere& sphere) {
  return {from_c(sphere.centre), sphere.radius};
}
inline ValidRoots from_c(const raycheck_valid_roots& v) {
  return {v.t_min, v.t_max, static_cast<Ends>(v.ends), static_cast<TUnit>(v.unit),
          static_cast<Culling>(v.culling)};
}
inline raycheck_valid_roots to_c(const ValidRoots& v) {
  return {v.t_min, v.t_max, static_cast<int32_t>(v.ends), static_cast<int32_t>(v.unit),
          static_cast<int32_t>(v.culling)};
}
inline Conventions from_c(const raycheck_conventions& c) {
  return {static_cast<Rows>(c.rows),       static_cast<Samples>(c.samples),
          static_cast<Origin>(c.origin),   static_cast<Root>(c.root),
          static_cast<Tangent>(c.tangent), from_c(*raycheck_valid_roots_of(&c))};
}

inline raycheck_frame frame(const raycheck_camera* camera) {
  const Frame answer = functions.frame(from_c(*camera));
  return {to_c(answer.u), to_c(answer.v), to_c(answer.w)};
}
inline raycheck_vector pixel_point(const raycheck_camera* camera, const raycheck_conventions* asked,
                                   raycheck_pixel pixel) {
  return to_c(functions.pixel_point(from_c(*camera), from_c(*asked), {pixel.i, pixel.j}));
}
inline raycheck_ray pixel_ray(const raycheck_camera* camera, const raycheck_conventions* asked,
                              raycheck_pixel pixel) {
  return to_c(functions.pixel_ray(from_c(*camera), from_c(*asked), {pixel.i, pixel.j}));
}
inline raycheck_ray focal_ray(const raycheck_camera* camera, const raycheck_conventions* asked,
                              raycheck_pixel pixel) {
  return to_c(functions.focal_ray(from_c(*camera), from_c(*asked), {pixel.i, pixel.j}));
}
inline raycheck_hit intersect(const raycheck_ray* ray, const raycheck_sphere* sphere,
                              const raycheck_conventions* asked) {
  const auto hit = functions.intersect(from_c(*ray), from_c(*sphere), from_c(*asked));
  if (!hit) return {0, 0, {0, 0, 0}};
  return {1, hit->parameter, to_c(hit->point)};
}
inline int64_t nearest(const raycheck_ray* ray, const raycheck_sphere* spheres, size_t count,
                       const raycheck_conventions* asked) {
  std::vector<Sphere> list;
  for (size_t k = 0; k < count; ++k) list.push_back(from_c(spheres[k]));
  const auto index = functions.nearest(from_c(*ray), list, from_c(*asked));
  return index ? static_cast<int64_t>(*index) : -1;
}

inline const raycheck_candidate* offer(const Functions& given) {
  functions = given;
  static raycheck_candidate candidate;
  candidate = {RAYCHECK_CANDIDATE_VERSION,
               given.name,
               {static_cast<int32_t>(given.rows), static_cast<int32_t>(given.samples),
                static_cast<int32_t>(given.origin), static_cast<int32_t>(given.root),
                static_cast<int32_t>(given.tangent)},
               given.frame ? frame : nullptr,
               given.pixel_point ? pixel_point : nullptr,
               given.pixel_ray ? pixel_ray : nullptr,
               given.focal_ray ? focal_ray : nullptr,
               given.intersect ? intersect : nullptr,
               nullptr,
               given.nearest ? nearest : nullptr,
               static_cast<int32_t>(given.level),
               given.smallest_length,
               given.largest_length,
               static_cast<int32_t>(given.precision),
               static_cast<int32_t>(given.roots),
               to_c(given.valid)};
  return &candidate;
}

}  // namespace detail
}  // namespace raycheck

/// Makes a shared library a candidate; use once, outside any namespace.
#define RAYCHECK_CANDIDATE(...)                                             \
  extern "C" const raycheck_candidate* raycheck_candidate_functions(void) { \
    return raycheck::detail::offer(raycheck::Functions{__VA_ARGS__});       \
  }

#endif  // RAYCHECK_CANDIDATE_HPP_
