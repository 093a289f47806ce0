#pragma once

#include <array>

#include "scene/camera.h"
#include "scene/conventions.h"
#include "scene/geometry.h"
#include "scene/plan/bounds.h"

namespace raycheck::scene {

/// Exponents of the powers of two that lengths are divided by. 0: not scaled.
struct Scaling {
  int plane = 0;    ///< For positions on the image plane and its distance from the eye.
  int lengths = 0;  ///< For lengths of spheres.
  bool operator==(const Scaling&) const = default;
};

/// Bounds on a sphere's position relative to the eye, which all rays through the eye share. Lengths
/// are divided by 2^Scaling::lengths.
template <class AnyBounds>
struct EyeSphereOf {
  AnyBounds u, v, w;      ///< (C - E).U, (C - E).V, (C - E).W
  AnyBounds distance_sq;  ///< |C - E|^2
  AnyBounds power;        ///< |C - E|^2 - r^2; negative if the eye is inside.
  AnyBounds radius;
  bool operator==(const EyeSphereOf&) const = default;
};
using EyeSphere = EyeSphereOf<Bounds>;

/// The columns (or rows) of the image plane.
struct PixelAxis {
  Bounds first, extent;   ///< The position where the plane begins, and its length.
  PixelSteps pixels;      ///< The steps of its length.
  bool reversed = false;  ///< Indices count from the other end.
};

/// The part of a x - b y below its leading double. Given are the exact rounding errors of a times
/// the leading part of x, of b times the leading part of y, and of the difference of these
/// products.
/// Error:  kDeterminantRoundings u^2 times the sum of the products' sizes, to first order.
template <class N>
N rest_of_determinant(const N& of_difference, const N& of_first, const N& of_second, const N& a,
                      const N& x_rest, const N& b, const N& y_rest) {
  return of_difference + ((of_first - of_second) + (a * x_rest - b * y_rest));
}
inline constexpr double kDeterminantRoundings = 15;

/// Bounds on a camera's axes and image plane.
/// Domain: a valid camera (scene/validate.h).
/// Error:  all bounds enclose the real values. Those on the axes are some ulps wide, unless E - A
///         or up x W nearly vanish, and exact if the axes are the world's (`axis_aligned`).
/// Source: docs/problem.md, section Camera.
class EyeSpace {
 public:
  using Axis = std::array<Bounds, 3>;

  /// If `general` is set, axes are computed even if they are the world's.
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

  /// n, alpha of a column and beta of a row, divided by 2^Scaling::plane. Rows count as the
  /// conventions say.
  Bounds near() const;
  Bounds alpha(double column) const;
  Bounds beta(double row) const;
  /// The inverses of alpha() and beta().
  Bounds column(const Bounds& alpha) const;
  Bounds row(const Bounds& beta) const;

 private:
  Bounds on_plane(double position) const;

  Camera camera_;
  Scaling scaling_;
  Axis U_, V_, W_;
  PixelAxis columns_, rows_;
  bool axis_aligned_ = false;
};

}  // namespace raycheck::scene
