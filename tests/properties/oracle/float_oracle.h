#pragma once

#include <array>
#include <optional>

#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::tests {

/// What integers say of a ray and a sphere whose numbers are floats, and of an answer. It shares
/// nothing with reference/: the literal formulas in MPFR, at a precision that loses nothing.
struct FloatTruth {
  bool is_line_hit = false;   ///< The line meets the sphere.
  bool is_tangent = false;    ///< In a double root.
  bool is_hit = false;        ///< Under the `root` convention, tangents counted.
  double s = 0;               ///< Correctly rounded to float, of a hit.
  std::array<double, 3> Q{};  ///< Likewise.
};

/// An answer's errors, to a relative 2^-40 and an absolute 2^-30.
struct FloatErrors {
  bool is_at_other_root = false;
  double s =
      0;  ///< In ulp of float of the exact s; infinite where that is 0 and the answer is not.
  double Q = 0;  ///< In u = 2^-24 of |Q|; likewise.
};

/// Domain: floats between 2^-126 and 2^126 in size, or 0; a direction that is not 0; radius >= 0.
FloatTruth float_truth(const scene::Ray& ray, const scene::Sphere& sphere, scene::Root root);

/// Domain: the same, of a hit; finite answers.
FloatErrors float_errors(const scene::Ray& ray, const scene::Sphere& sphere, scene::Root root,
                         double s, const scene::Point3& Q);

}  // namespace raycheck::tests
