#include "reference/visibility/visibility_pairs.h"

#include <algorithm>
#include <cmath>

namespace raycheck::reference {
namespace {

Pair pair(const DoubleDouble& x) { return {x.high(), x.low()}; }

}  // namespace

PairAxis::PairAxis(double low, double high, std::int64_t pixels, scene::Samples samples)
    : first(low),
      turned(scene::pixel_steps(samples, pixels).turned()),
      count(static_cast<double>(pixels)),
      most(std::max(std::abs(low), std::abs(high))) {
  const DoubleDouble extent = DoubleDouble(high) - DoubleDouble(low);
  const auto [offset, steps] = scene::pixel_steps(samples, pixels);
  step = extent / DoubleDouble(steps);
  if (offset != 0) first += extent / DoubleDouble(steps / offset);
}

/// index * step is at most 2 * most. The rounding error of a sum of DoubleDouble is a share of its
/// larger operand.
double PairAxis::doubt() const {
  return kSlack * (first.radius() + count * step.radius() + 4 * kDoubleDoubleError * most);
}

PairView::PairView(const ExactCamera& camera)
    : camera_(camera.camera()),
      frame_(camera.frame_in_double_doubles()),
      columns_(camera_.left, camera_.right, camera_.width, camera.conventions().samples),
      rows_(camera_.bottom, camera_.top, camera_.height, camera.conventions().samples),
      is_top_first_(camera.conventions().rows == scene::Rows::kTopFirst) {
  sizes_.u0 = kDoubleDoubleError;
  sizes_.N = std::abs(camera_.near);
  sizes_.X = columns_.most;
  sizes_.Y = rows_.most;
  sizes_.delta = std::max(columns_.doubt(), rows_.doubt());
  sizes_.set_squares();
}

FilteredSphereOf<Pair> PairView::sphere(const scene::Sphere& sphere, std::size_t index) const {
  const auto lifted = [](const auto& p) {
    return Triple<DoubleDouble>{DoubleDouble(p.x), DoubleDouble(p.y), DoubleDouble(p.z)};
  };
  const Triple<DoubleDouble> f = lifted(sphere.centre) - lifted(camera_.eye);
  const DoubleDouble u = dot(f, frame_.U), v = dot(f, frame_.V), w = dot(f, frame_.W);
  const DoubleDouble radius_sq = DoubleDouble(sphere.radius) * DoubleDouble(sphere.radius);
  const DoubleDouble power = dot(f, f) - radius_sq;
  FilteredSphere high;
  high.u = u.high();
  high.v = v.high();
  high.w = w.high();
  high.power = power.high();
  high.radius_sq = radius_sq.high();
  const double rho = std::max({u.radius(), v.radius(), w.radius()});
  const SphereBound bound = bound_of(high, {rho, power.radius(), radius_sq.radius()}, sizes_);
  FilteredSphereOf<Pair> result{pair(u), pair(v), pair(w), {}, pair(radius_sq)};
  result.index = static_cast<std::int32_t>(index);
  set_bound(bound, true, result);
  result.exact = result.exact || !bound.has_moment;
  return result;
}

PairRays PairView::rays(const TileRays& same, std::int64_t first_column,
                        std::int64_t first_row) const {
  PairRays rays;
  rays.start_factor = same.start_factor;
  rays.start_margin = 2 * same.start_factor * sizes_.E_a;
  rays.larger_counts = same.larger_counts;
  rays.near.high = camera_.near;
  rays.first = pair(columns_.first);
  rays.step = pair(columns_.step);
  rays.first_column = static_cast<double>(first_column);
  const std::int64_t rows = std::min<std::int64_t>(Tile::kHeight, camera_.height - first_row);
  for (std::int64_t k = 0; k < rows; ++k) {
    const auto row = static_cast<double>(first_row + k);
    const double index = is_top_first_ ? rows_.turned - row : row;
    rays.beta[static_cast<std::size_t>(k)] = pair(rows_.first + DoubleDouble(index) * rows_.step);
  }
  return rays;
}

}  // namespace raycheck::reference
