#pragma once

// The filter before intervals: a ray's line and the signs of a sphere's coefficients
// (reference/internal/classify.h) in doubles, with bounds on their errors. Internal to reference/.

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/internal/classify.h"
#include "reference/internal/triple.h"

namespace raycheck::reference {

/// An operation on doubles is off by at most this share of its result, in every rounding mode,
/// unless it underflows.
inline constexpr double kQuickRounding = 0x1p-52;
/// Lengths within these bounds are filtered: then nothing overflows, and what underflow loses, a
/// few times 2^-1074 times lengths, is far below the doubts, which are at least 2^-900.
inline constexpr double kLeastQuick = 0x1p-200, kMostQuick = 0x1p200;

inline double sum_of_sizes(const Triple<double>& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// A camera's axes: each coordinate is within `doubt` of these.
struct QuickAxes {
  double doubt = 0;
  Triple<double> U, V, W;

  explicit QuickAxes(const Axes<IntervalKernel>& axes)
      : U(least(axes.U)), V(least(axes.V)), W(least(axes.W)) {
    if (!(doubt <= 0x1p-30)) doubt = HUGE_VAL;  // the bounds on errors need it
  }

 private:
  Triple<double> least(const IntervalKernel::Vector_3& v) {
    for (const Interval& x : {v.x(), v.y(), v.z()}) doubt = std::max(doubt, x.sup() - x.inf());
    return {v.x().inf(), v.y().inf(), v.z().inf()};
  }
};

/// A line (reference/internal/formulas.h): each coordinate of g is within `doubt` of the exact one.
/// `size` is an upper bound on |g| and on the exact coordinates, and a on size^2.
/// Error: with e = kQuickRounding, a position alpha = low + (index/steps) (high - low), where the
///        quotient is at most 1, is off by at most 5 e (|low| + |high|), and n W + alpha U + beta V
///        by at most (5 + 4) e size + doubt of the axes, times size. |g|^2 is off by at most
///        16 e size^2.
struct QuickLine {
  Triple<double> g;
  double a, size, doubt;

  static QuickLine given(const Triple<double>& direction) {
    const auto& [x, y, z] = direction;
    return {direction, x * x + y * y + z * z, sum_of_sizes(direction), 0};
  }
  static QuickLine through(const QuickAxes& axes, const scene::Camera& camera, double alpha,
                           double beta) {
    const double n = camera.near;
    const auto along = [&](double U, double V, double W) { return n * W + alpha * U + beta * V; };
    const double size = std::abs(n) + std::abs(camera.left) + std::abs(camera.right) +
                        std::abs(camera.bottom) + std::abs(camera.top);
    return {{along(axes.U.x, axes.V.x, axes.W.x), along(axes.U.y, axes.V.y, axes.W.y),
             along(axes.U.z, axes.V.z, axes.W.z)},
            n * n + alpha * alpha + beta * beta,
            size,
            (10 * kQuickRounding + 1.01 * axes.doubt) * size};
  }
};

/// A position on the image plane, as plane_coordinate() of reference/internal/formulas.h.
inline double quick_coordinate(double low, double high, const PixelIndex& at) {
  const double index = at.is_from_high ? at.steps.turned() - at.index : at.index;
  return low + (index + at.steps.offset) * (high - low) / at.steps.steps;
}

inline PlanePosition<double> quick_position(const scene::Camera& camera,
                                            const scene::Conventions& conventions,
                                            const scene::Pixel& pixel) {
  const auto [column, row] = indices_of(camera, conventions, pixel);
  return {quick_coordinate(camera.left, camera.right, column),
          quick_coordinate(camera.bottom, camera.top, row)};
}

/// A line and a sphere.
class QuickPair {
 public:
  QuickPair(const QuickLine& line, bool starts_at_g, const scene::Point3& base,
            const scene::Sphere& sphere)
      : line_(line), starts_at_g_(starts_at_g), radius_(sphere.radius) {
    f_ = {sphere.centre.x - base.x, sphere.centre.y - base.y, sphere.centre.z - base.z};
    f_size_ = sum_of_sizes(f_);
  }

  /// Whether the bounds on errors apply.
  bool is_in_range() const {
    double least = std::min({f_size_, line_.size, radius_});
    double most = std::max({f_size_, line_.size, radius_});
    return least >= kLeastQuick && most <= kMostQuick;
  }

  /// A number, and a bound on its error.
  struct Doubtful {
    double value, doubt;
  };
  /// Domain: is_in_range().
  Doubtful value(Coefficient of) const {
    constexpr double e = kQuickRounding;
    const double size = line_.size, r = radius_;
    if (of == Coefficient::kDiscriminant) {
      // f and g are off by e |f| and the line's doubt; a coordinate of f x g by at most `off`.
      const Triple<double> moment = cross(f_, line_.g);
      const double off = f_size_ * (1.01 * line_.doubt + 5 * e * size);
      const double squared = dot(moment, moment), grown = size * size * r * r;
      return {line_.a * r * r - squared, 1.01 * (2 * sum_of_sizes(moment) * off + 3 * off * off +
                                                 5 * e * squared + 20 * e * grown)};
    }
    Triple<double> t = f_;
    double t_size = f_size_, t_doubt = e * f_size_;
    if (starts_at_g_) {
      t = t - line_.g;
      t_size += 2 * size;
      t_doubt += line_.doubt + e * t_size;
    }
    if (of == Coefficient::kConstant) {
      return {dot(t, t) - r * r, 1.01 * (2 * t_size * t_doubt + 3 * t_doubt * t_doubt +
                                         5 * e * (t_size * t_size + r * r))};
    }
    return {dot(t, line_.g), 1.01 * (t_size * line_.doubt + 2 * size * t_doubt +
                                     3 * t_doubt * line_.doubt + 6 * e * t_size * size)};
  }
  /// The sign of a coefficient; empty if it is not certain that it is 1 or -1.
  std::optional<int> sign(Coefficient of) const {
    const auto [value, doubt] = this->value(of);
    return value > doubt ? std::optional(1) : value < -doubt ? std::optional(-1) : std::nullopt;
  }

 private:
  const QuickLine& line_;
  bool starts_at_g_;
  double radius_;
  Triple<double> f_;
  double f_size_;
};

}  // namespace raycheck::reference
