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
  /// The signed position of the image plane along W, in scene lengths. Domain: not 0.
  double near_plane = 0;
  /// The image's bounds, in scene lengths. Domain: left and right differ, bottom and top differ.
  double left = 0, right = 0, bottom = 0, top = 0;
  std::int64_t width = 0, height = 0;  ///< In pixels. Domain: >= 1; >= 2 for Samples::edges.
};

/// The camera axes.
struct Frame {
  Vector u, v, w;  ///< Unit, at right angles.
};

/// The pixel in column i and row j.
struct Pixel {
  std::int64_t i = 0, j = 0;  ///< Domain: 0 <= i < width, 0 <= j < height.
};

/// The points origin + s direction, s >= 0 (lines: every s). The direction need not be unit.
struct Ray {
  Vector origin, direction;  ///< Domain: the direction is not 0.
};

/// A sphere; with a radius of 0, a point.
struct Sphere {
  Vector centre;      ///< In scene lengths.
  double radius = 0;  ///< In scene lengths. Domain: at least 0.
};

/// The point where a ray meets a sphere, as a candidate computes it.
struct Hit {
  double parameter = 0;  ///< s, in multiples of the ray's direction.
  Vector point;          ///< Q, the point of the ray at s.
};

/// Which row of pixels is j = 0.
enum class Rows { as_asked, bottom_first, top_first };
/// Where a pixel's point lies: i/(w-1), (i+1/2)/w or i/w of the way across; rows likewise, from the
/// side of row 0.
enum class Samples { as_asked, edges, centres, corners };
/// Where rays start: at the pixel's point P or at the eye E.
enum class Origin { as_asked, pixel, focal };
/// Which root is the hit. nearest: the smallest root >= 0. smaller: the smaller root; if it is
/// negative, the ray misses.
enum class Root { as_asked, nearest, smaller };
/// Whether a ray that touches a sphere hits it.
enum class Tangent { as_asked, hit, miss, either };

/// Which of t_min and t_max themselves count. open_max: t_max does not; open: neither does.
enum class Ends { closed, open_max, open_min, open };
/// The unit of t_min and t_max: s itself, radii of the sphere, or scene lengths along the ray.
enum class TUnit { absolute, radius, length };
/// Which root never counts: the larger root, on a back face, or the smaller root, on a front face.
enum class Culling { none, back_faces, front_faces };

/// The roots that count: those from t_min to t_max that are not culled. By default, every root >= 0
/// counts.
struct ValidRoots {
  double t_min = 0;  ///< Smaller roots do not count. -infinity: a line is intersected, not a ray.
  double t_max = std::numeric_limits<double>::infinity();  ///< Larger roots do not count.
  Ends ends = Ends::closed;         ///< Whether t_min and t_max themselves count.
  TUnit unit = TUnit::absolute;     ///< Their unit.
  Culling culling = Culling::none;  ///< Which faces never count.
};

/// The roots that a candidate accepts: every root >= 0, the valid roots that it declares, or the
/// valid roots that the scene asks for.
enum class Roots { usual, declared, as_asked };

/// The directions that a candidate accepts. unit: it is called only with directions of length 1, up
/// to rounding.
enum class Directions { any, unit };

/// What a candidate returns for a hit: s and Q; s; Q; as Hit::parameter, the distance of Q along
/// the ray in scene lengths or the square of this distance; only that there is a hit; or both roots
/// of the ray's line, v - d as Hit::parameter and v + d as Hit::point.x.
enum class Returns { hit, parameter, point, distance, squared_distance, class_only, roots };

/// The choices that the lecture leaves open. For libraycheck, as_asked means the default.
struct Conventions {
  Rows rows = Rows::as_asked;           ///< Default: bottom_first.
  Samples samples = Samples::as_asked;  ///< Default: edges.
  Origin origin = Origin::as_asked;     ///< Default: pixel.
  Root root = Root::as_asked;           ///< Default: nearest.
  Tangent tangent = Tangent::as_asked;  ///< Default: hit.
  ValidRoots valid = {};                ///< Default: every root >= 0.
};

/// A camera or given rays, the spheres that the rays may meet, and the conventions.
struct Scene {
  std::optional<Camera> camera;  ///< Empty if rays are given.
  std::vector<Ray> rays;         ///< Empty if there is a camera.
  std::vector<Sphere> spheres;   ///< The index of a sphere is its place in this list.
  Conventions conventions;       ///< A candidate must follow them.
};

/// The format that a candidate computes in and is judged in.
enum class Precision { double_, single };

/// The difficulty of the cases that a candidate must get right. Careful code in doubles gets
/// ordinary cases right; demanding cases need stable formulas; extreme cases include all that
/// doubles can express.
enum class Level { unstated, ordinary, demanding, extreme };

}  // namespace raycheck

#endif  // RAYCHECK_SCENE_H_
