#ifndef RAYCHECK_SCENE_H_
#define RAYCHECK_SCENE_H_

// Cameras, rays, spheres: plain structs, shared by candidates and libraycheck. C++17.

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace raycheck {

/// A point or a vector. Doubles are taken exactly as given.
struct Vector {
  double x = 0, y = 0, z = 0;  ///< Scene lengths.
};

/// W = (eye - look_at) normalised, U = up x W normalised, V = W x U. The image plane is at
/// near_plane along W, which is negative in front of the eye; its bounds are along U and V.
struct Camera {
  Vector eye, look_at, up;  ///< Domain: eye and look_at differ, up is not parallel to W.
  /// Signed, in scene lengths. Domain: not 0.
  double near_plane = 0;
  /// Of the image plane, in scene lengths. Domain: left and right differ, bottom and top differ.
  double left = 0, right = 0, bottom = 0, top = 0;
  std::int64_t width = 0, height = 0;  ///< In pixels. Domain: at least 1; 2 for edges.
};

/// The camera axes.
struct Frame {
  Vector u, v, w;  ///< Unit, at right angles.
};

/// Column i of width, row j of height.
struct Pixel {
  std::int64_t i = 0, j = 0;  ///< Domain: 0 <= i < width, 0 <= j < height.
};

/// The points origin + s direction, s >= 0. The direction need not be unit.
struct Ray {
  Vector origin, direction;  ///< Domain: the direction is not 0.
};

/// A radius of 0 is a point.
struct Sphere {
  Vector centre;      ///< In scene lengths.
  double radius = 0;  ///< In scene lengths. Domain: at least 0.
};

/// Where a candidate finds that a ray meets a sphere.
struct Hit {
  double parameter = 0;  ///< s, in multiples of the ray's direction.
  Vector point;          ///< Q, the point of the ray at s.
};

/// Which row of pixels is j = 0.
enum class Rows { as_asked, bottom_first, top_first };
/// Where in its column or row a pixel's point lies: i/(w-1) or (i+1/2)/w of the way across.
enum class Samples { as_asked, edges, centres };
/// Where rays start: at the pixel's point P or at the eye E.
enum class Origin { as_asked, pixel, focal };
/// Which root is the hit: the smallest that is at least 0, or the smaller one; a negative one is a
/// miss.
enum class Root { as_asked, nearest, smaller };
/// Whether a ray that touches a sphere hits it.
enum class Tangent { as_asked, hit, miss, either };

/// Which ends belong to [t_min, t_max].
enum class Ends { closed, open_max, open_min, open };
/// The unit of t_min and t_max: s itself, radii of the sphere, or scene lengths along the ray.
enum class TUnit { absolute, radius, length };
/// Which roots never count: v + d, on back faces, or v - d, on front faces.
enum class Culling { none, back_faces, front_faces };

/// Which roots count: those between t_min and t_max, in s, in radii of the sphere or in scene
/// lengths, that are not culled: v + d lies on back faces, v - d on front faces. By default: every
/// root >= 0.
struct ValidRoots {
  double t_min = 0;  ///< The least that counts; -infinity where lines are met, not rays.
  double t_max = std::numeric_limits<double>::infinity();  ///< Likewise the largest; >= t_min.
  Ends ends = Ends::closed;         ///< Whether t_min and t_max themselves count.
  TUnit unit = TUnit::absolute;     ///< Their unit.
  Culling culling = Culling::none;  ///< Which faces never count.
};

/// Whether a candidate accepts every root >= 0, the valid roots that it declares, or those that the
/// scene asks for.
enum class Roots { usual, declared, as_asked };

/// Which directions a candidate accepts; unit: it is called only with directions of length 1, up to
/// rounding.
enum class Directions { any, unit };

/// What a candidate returns for a hit: s and Q; s; Q; the distance of Q along the ray in scene
/// lengths, or its square, as Hit::parameter; or only that there is a hit.
enum class Returns { hit, parameter, point, distance, squared_distance, class_only };

/// The choices that the lecture leaves open. libraycheck reads as_asked as the value named here.
struct Conventions {
  Rows rows = Rows::as_asked;           ///< Else bottom_first.
  Samples samples = Samples::as_asked;  ///< Else edges.
  Origin origin = Origin::as_asked;     ///< Else pixel.
  Root root = Root::as_asked;           ///< Else nearest.
  Tangent tangent = Tangent::as_asked;  ///< Else hit.
  ValidRoots valid = {};                ///< Else every root >= 0.
};

/// A camera's rays, or given ones, the spheres that they may meet, and the conventions.
struct Scene {
  std::optional<Camera> camera;  ///< Empty if rays are given.
  std::vector<Ray> rays;         ///< Empty if there is a camera.
  std::vector<Sphere> spheres;   ///< Indices count in this order.
  Conventions conventions;       ///< A candidate must follow them.
};

/// The format that a candidate computes in, and is judged in.
enum class Precision { double_, single };

/// How hard the cases are that a candidate must get right: ordinary (careful doubles), demanding
/// (stable formulas), extreme (all that doubles can express).
enum class Level { unstated, ordinary, demanding, extreme };

}  // namespace raycheck

#endif  // RAYCHECK_SCENE_H_
