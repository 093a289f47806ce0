#ifndef RAYCHECK_SCENE_H_
#define RAYCHECK_SCENE_H_

// What is looked at: plain structs, shared by candidates and by libraycheck. C++17.

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace raycheck {

/// A point or a vector. Doubles are taken exactly as given.
struct Vector {
  double x = 0, y = 0, z = 0;
};

/// W = (eye - look_at) normalised, U = up x W normalised, V = W x U. The image plane is at
/// near_plane along W, which is negative in front of the eye; its bounds are along U and V.
struct Camera {
  Vector eye, look_at, up;
  double near_plane = 0;
  double left = 0, right = 0, bottom = 0, top = 0;
  std::int64_t width = 0, height = 0;
};

/// The camera axes.
struct Frame {
  Vector u, v, w;
};

/// Column i of width, row j of height.
struct Pixel {
  std::int64_t i = 0, j = 0;
};

/// The points origin + s direction, s >= 0. The direction need not be unit.
struct Ray {
  Vector origin, direction;
};

/// A radius of 0 is a point.
struct Sphere {
  Vector centre;
  double radius = 0;
};

/// Where an implementation finds that a ray meets a sphere.
struct Hit {
  double parameter = 0;  ///< s, in multiples of the ray's direction.
  Vector point;          ///< Q
};

enum class Rows { as_asked, bottom_first, top_first };
enum class Samples { as_asked, edges, centres };
enum class Origin { as_asked, pixel, focal };
enum class Root { as_asked, nearest, smaller };
enum class Tangent { as_asked, hit, miss, either };

enum class Ends { closed, open_max, open_min, open };
enum class TUnit { absolute, radius };
enum class Culling { none, back_faces, front_faces };

/// Which roots count: those between t_min and t_max, in s or in radii of the sphere, that are not
/// culled: v + d lies on back faces, v - d on front faces. As it is: every root >= 0.
struct ValidRoots {
  double t_min = 0, t_max = std::numeric_limits<double>::infinity();
  Ends ends = Ends::closed;
  TUnit unit = TUnit::absolute;
  Culling culling = Culling::none;
};

/// Whether an implementation takes every root >= 0, the valid roots that it declares, or those that
/// it is asked for.
enum class Roots { usual, declared, as_asked };

/// What the lecture leaves open. Asked of libraycheck, as_asked stands for the first that is named.
struct Conventions {
  Rows rows = Rows::as_asked;
  Samples samples = Samples::as_asked;
  Origin origin = Origin::as_asked;
  Root root = Root::as_asked;
  Tangent tangent = Tangent::as_asked;
  ValidRoots valid = {};
};

/// A camera's rays, or given ones, the spheres that they may meet, and the conventions.
struct Scene {
  std::optional<Camera> camera;
  std::vector<Ray> rays;  ///< Empty where there is a camera.
  std::vector<Sphere> spheres;
  Conventions conventions;
};

/// The format that an implementation computes in, and is judged in.
enum class Precision { double_, single };

/// Up to which cases an implementation is to be right: ordinary ones (careful doubles), demanding
/// ones (stable formulas), extreme ones (all that doubles can say).
enum class Level { unstated, ordinary, demanding, extreme };

}  // namespace raycheck

#endif  // RAYCHECK_SCENE_H_
