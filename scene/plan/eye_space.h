#pragma once

#include <array>

#include "scene/camera.h"
#include "scene/conventions.h"
#include "scene/geometry.h"
#include "scene/plan/bounds.h"

namespace raycheck::scene {

/// Exponents of the powers of two that lengths are divided by: positions on the image plane and its
/// distance from the eye; and lengths of spheres. 0: unscaled.
struct Scaling {
  int plane = 0;
  int lengths = 0;
  bool operator==(const Scaling&) const = default;
};

/// A sphere relative to the eye, within bounds: shared by all rays through the eye. Lengths are
/// divided by 2^Scaling::lengths.
template <class AnyBounds>
struct EyeSphereOf {
  AnyBounds u, v, w;      ///< (C - E).U, (C - E).V, (C - E).W
  AnyBounds distance_sq;  ///< |C - E|^2
  AnyBounds power;        ///< |C - E|^2 - r^2: negative where the eye is inside.
  AnyBounds radius;
  bool operator==(const EyeSphereOf&) const = default;
};
using EyeSphere = EyeSphereOf<Bounds>;

/// The image plane's columns (or rows) in the order of their indices.
struct PixelAxis {
  Bounds first, extent;  ///< Where the plane's side begins, and its length.
  double pixels = 0;     ///< The number of samples that fit into that, and the last index.
  double last = 0;
  bool centred = false;
  bool reversed = false;  ///< Counted from the other end.
};

/// The part of a x - b y below its leading double. The rounding errors of the products of a and b
/// with the leading parts of x and y, and of these products' difference, are given exactly. Off by
/// kDeterminantRoundings u^2, to first order, where the products add up to 1.
template <class N>
N rest_of_determinant(const N& of_difference, const N& of_first, const N& of_second, const N& a,
                      const N& x_rest, const N& b, const N& y_rest) {
  return of_difference + ((of_first - of_second) + (a * x_rest - b * y_rest));
}
inline constexpr double kDeterminantRoundings = 15;

/// A camera's axes and image plane, within bounds.
/// Domain: a valid camera (scene/validate.h).
/// Error:  every bound holds the real value; the axes are some ulps wide, unless E - A or up x W
///         nearly vanish, and exact where they are the world's (`axis_aligned`).
/// Source: docs/problem.md, section Camera.
class EyeSpace {
 public:
  using Axis = std::array<Bounds, 3>;

  /// `general` treats the world's axes like any others, as computed bounds.
  EyeSpace(const Camera& camera, const Conventions& conventions, const Scaling& scaling,
           bool general = false);

  /// Each of U, V, W is a world axis or its opposite.
  bool axis_aligned() const { return axis_aligned_; }
  const Axis& U() const { return U_; }
  const Axis& V() const { return V_; }
  const Axis& W() const { return W_; }
  const Scaling& scaling() const { return scaling_; }
  const Point3& eye() const { return camera_.eye; }
  const PixelAxis& columns() const { return columns_; }
  const PixelAxis& rows() const { return rows_; }
  EyeSphere sphere(const Sphere& sphere) const;

  /// n, alpha of a column and beta of a row j, as the conventions count them, divided by
  /// 2^Scaling::plane.
  Bounds near() const;
  Bounds alpha(double column) const;
  Bounds beta(double row) const;
  /// The column (or row) of a position on the image plane: the inverse of `alpha`.
  Bounds column(const Bounds& alpha) const;
  Bounds row(const Bounds& beta) const;

 private:
  Bounds on_plane(double position) const;

  Camera camera_;
  Conventions conventions_;
  Scaling scaling_;
  Axis U_, V_, W_;
  PixelAxis columns_, rows_;
  bool axis_aligned_ = false;
};

}  // namespace raycheck::scene
