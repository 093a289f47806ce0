#include "scene/plan/eye_space.h"

#include <algorithm>
#include <cmath>

#include "scene/plan/plan_kernel.h"

namespace raycheck::scene {
namespace {

#include "scene/plan/sphere_formula.h"

using Axis = EyeSpace::Axis;

Axis cross(const Axis& x, const Axis& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

Axis normalised(const Axis& x) {
  const Bounds length = sqrt(square(x[0]) + square(x[1]) + square(x[2]));
  return {x[0] / length, x[1] / length, x[2] / length};
}

template <class Triple>
Axis exactly(const Triple& v) {
  return {Bounds::exactly(v.x), Bounds::exactly(v.y), Bounds::exactly(v.z)};
}

Axis difference(const Point3& to, const Point3& from) {
  const Axis a = exactly(to), b = exactly(from);
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

bool is_zero(const Bounds& x) { return x.low == 0 && x.high == 0; }

/// Whether a vector points along a world axis or its opposite; then sets `axis` to it.
bool along_world_axis(const Axis& v, Axis& axis) {
  if (std::ranges::count_if(v, is_zero) != 2) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (v[k].contains(0) && !is_zero(v[k])) return false;
    axis[k] = Bounds::exactly(is_zero(v[k]) ? 0 : v[k].low > 0 ? 1 : -1);
  }
  return true;
}

/// The exponent of the largest coordinate. Vectors are scaled by it, since squares of huge
/// coordinates would overflow and squares of tiny coordinates vanish.
int exponent_of(const Axis& v) {
  double most = 0;
  for (const Bounds& x : v) most = std::max({most, std::abs(x.low), std::abs(x.high)});
  return most > 0 && std::isfinite(most) ? std::ilogb(most) : 0;
}

Axis scaled(const Axis& v, int exponent) {
  return {scaled(v[0], exponent), scaled(v[1], exponent), scaled(v[2], exponent)};
}

/// The vector scaled so that its largest coordinate is near 1.
Axis scaled_near_one(const Axis& v) { return scaled(v, -exponent_of(v)); }

/// An exact difference: the rounded difference and its rounding error.
struct Difference {
  double x, rest;
};
Difference difference(double x, double y) {
  const double rounded = x - y;
  const double of_y = x - rounded;
  return {rounded, (x - (rounded + of_y)) + (of_y - y)};
}

/// For numbers of at least this size, the rounding error of a product is a double.
constexpr double kLeastFactor = 0x1p-400;

bool is_plain(double x) { return x == 0 || std::abs(x) >= kLeastFactor; }

/// a x - b y by exact products, precise even if it cancels.
Bounds determinant(double a, const Difference& x, double b, const Difference& y) {
  const double first = a * x.x, second = b * y.x;
  if (first == 0 && second == 0) return Bounds::exactly(0);
  const Difference leading = difference(first, second);
  const double rest = rest_of_determinant(leading.rest, std::fma(a, x.x, -first),
                                          std::fma(b, y.x, -second), a, x.rest, b, y.rest);
  constexpr double kShare = 16 * 0x1p-106;  // covers the doubt's own roundings, too
  static_assert(kShare > 1.01 * kDeterminantRoundings * 0x1p-106);
  const double doubt = kShare * (std::abs(first) + std::abs(second));
  return Bounds::exactly(leading.x) + (Bounds::exactly(rest) + Bounds{-doubt, doubt});
}

/// up x (E - A), up to a positive factor. In the plain range it is precise even if up and E - A are
/// nearly parallel; elsewhere it is computed from bounds on E - A.
Axis across(const Camera& camera, const Axis& to_eye) {
  const Axis up = scaled_near_one(exactly(camera.up));
  const Point3 &E = camera.eye, &A = camera.look_at;
  const Difference to[] = {difference(E.x, A.x), difference(E.y, A.y), difference(E.z, A.z)};
  const bool is_all_plain = std::ranges::all_of(to, [](const Difference& d) {
    return is_plain(d.x) && is_plain(d.rest) && std::abs(d.x) < 1 / kLeastFactor;
  });
  if (!is_all_plain || !std::ranges::all_of(up, [](const Bounds& x) {
        return x.low == x.high && is_plain(x.low);
      })) {
    return cross(up, to_eye);
  }
  const auto coordinate = [&](std::size_t j, std::size_t k) {
    return determinant(up[j].low, to[k], up[k].low, to[j]);
  };
  return {coordinate(1, 2), coordinate(2, 0), coordinate(0, 1)};
}

Bounds position_of(double index, const PixelAxis& axis) {
  const auto& [offset, steps] = axis.pixels;
  const double from_first = axis.reversed ? axis.pixels.turned() - index : index;
  return axis.first + Bounds::exactly(from_first + offset) / Bounds::exactly(steps) * axis.extent;
}

}  // namespace

EyeSpace::EyeSpace(const Camera& camera, const Conventions& conventions, const Scaling& scaling,
                   bool general)
    : camera_(camera), scaling_(scaling) {
  const Axis w = scaled_near_one(difference(camera.eye, camera.look_at));
  const Axis u = scaled_near_one(across(camera, w));
  axis_aligned_ = !general && along_world_axis(w, W_) && along_world_axis(u, U_);
  if (!axis_aligned_) {
    W_ = normalised(w);
    U_ = normalised(u);
    V_ = cross(W_, U_);
  } else {
    along_world_axis(cross(W_, U_), V_);
  }
  const auto axis = [&](double low, double high, std::int64_t count) {
    const Bounds first = on_plane(low);
    return PixelAxis{first, on_plane(high) - first, pixel_steps(conventions.samples, count)};
  };
  columns_ = axis(camera.left, camera.right, camera.width);
  rows_ = axis(camera.bottom, camera.top, camera.height);
  rows_.reversed = conventions.rows == Rows::kTopFirst;
}

EyeSphere EyeSpace::sphere(const Sphere& sphere) const {
  const auto& [x, y, z] = sphere.centre;
  return seen_from<double>(*this, {x, y, z}, sphere.radius);
}

Bounds EyeSpace::on_plane(double position) const {
  return scaled(Bounds::exactly(position), -scaling_.plane);
}

Bounds EyeSpace::near() const { return on_plane(camera_.near); }

Bounds EyeSpace::alpha(double column) const { return position_of(column, columns_); }

Bounds EyeSpace::beta(double row) const { return position_of(row, rows_); }

Bounds EyeSpace::column(const Bounds& alpha) const { return index_of(columns_, alpha); }

Bounds EyeSpace::row(const Bounds& beta) const { return index_of(rows_, beta); }

}  // namespace raycheck::scene
