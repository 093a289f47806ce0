#ifndef RAYCHECK_CANDIDATE_HPP_
#define RAYCHECK_CANDIDATE_HPP_

// Makes a candidate of plain functions on plain structs (`--candidate source:FILE.cpp`):
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
// <raycheck/candidate.h> says what each function must do. Declare the conventions that your code
// fixes: RAYCHECK_CANDIDATE(.rows = Rows::top_first, .pixel_ray = pixel_ray). Name members in the
// order of Functions. This header needs C++17; GCC and Clang accept designated initializers there.

#include <raycheck/candidate.h>
#include <raycheck/scene.h>

#include <cstddef>
#include <cstring>
#include <optional>
#include <vector>

namespace raycheck {

/// The declarations and the functions of a candidate. It lacks the functions that are null.
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
  /// The point of the sphere that is seen through a pixel.
  std::optional<Hit> (*pick)(const Camera&, const Conventions&, Pixel, const Sphere&) = nullptr;
  Level level = Level::unstated;
  /// Scenes with a nonzero length outside these bounds are not judged; both 0: 2^-960 and inf.
  double smallest_length = 0, largest_length = 0;
  /// single: all inputs are floats, passed as doubles; errors are counted in u and ulp of float.
  Precision precision = Precision::double_;
  Roots roots = Roots::usual;
  ValidRoots valid = {};  ///< Used only if roots is Roots::declared.
  Directions directions = Directions::any;
  Returns returns = Returns::hit;
  /// More declarations, in the words of `raycheck list`: "samples centres; t_min 1e-4".
  const char* contract = nullptr;
};

namespace detail {

inline Functions functions;

/// The structs of both headers have the same members.
template <class To, class From>
To as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(static_cast<void*>(&to), &from, sizeof to);
  return to;
}
inline Conventions asked_of(const raycheck_conventions* conventions) {
  return as<Conventions>(*(const raycheck_asked*)(const void*)conventions);
}

inline raycheck_frame frame(const raycheck_camera* camera) {
  return as<raycheck_frame>(functions.frame(as<Camera>(*camera)));
}
inline raycheck_vector pixel_point(const raycheck_camera* camera, const raycheck_conventions* asked,
                                   raycheck_pixel pixel) {
  return as<raycheck_vector>(
      functions.pixel_point(as<Camera>(*camera), asked_of(asked), as<Pixel>(pixel)));
}
inline raycheck_ray pixel_ray(const raycheck_camera* camera, const raycheck_conventions* asked,
                              raycheck_pixel pixel) {
  return as<raycheck_ray>(
      functions.pixel_ray(as<Camera>(*camera), asked_of(asked), as<Pixel>(pixel)));
}
inline raycheck_ray focal_ray(const raycheck_camera* camera, const raycheck_conventions* asked,
                              raycheck_pixel pixel) {
  return as<raycheck_ray>(
      functions.focal_ray(as<Camera>(*camera), asked_of(asked), as<Pixel>(pixel)));
}
inline raycheck_hit hit_of(const std::optional<Hit>& hit) {
  return hit ? raycheck_hit{1, hit->parameter, as<raycheck_vector>(hit->point)} : raycheck_hit{};
}
inline raycheck_hit intersect(const raycheck_ray* ray, const raycheck_sphere* sphere,
                              const raycheck_conventions* asked) {
  return hit_of(functions.intersect(as<Ray>(*ray), as<Sphere>(*sphere), asked_of(asked)));
}
inline raycheck_hit pick(const raycheck_camera* camera, const raycheck_conventions* asked,
                         raycheck_pixel pixel, const raycheck_sphere* sphere) {
  return hit_of(
      functions.pick(as<Camera>(*camera), asked_of(asked), as<Pixel>(pixel), as<Sphere>(*sphere)));
}
inline int64_t nearest(const raycheck_ray* ray, const raycheck_sphere* spheres, size_t count,
                       const raycheck_conventions* asked) {
  std::vector<Sphere> list;
  for (size_t k = 0; k < count; ++k) list.push_back(as<Sphere>(spheres[k]));
  const auto index = functions.nearest(as<Ray>(*ray), list, asked_of(asked));
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
               as<raycheck_valid_roots>(given.valid),
               static_cast<int32_t>(given.directions),
               static_cast<int32_t>(given.returns),
               given.contract,
               given.pick ? pick : nullptr};
  return &candidate;
}

}  // namespace detail
}  // namespace raycheck

/// Makes a shared library a candidate. Use it once, outside any namespace.
#define RAYCHECK_CANDIDATE(...)                                             \
  extern "C" const raycheck_candidate* raycheck_candidate_functions(void) { \
    return raycheck::detail::offer(raycheck::Functions{__VA_ARGS__});       \
  }

#endif  // RAYCHECK_CANDIDATE_HPP_
