#include "reference/visibility/visibility_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace raycheck::reference {
namespace {

using scene::Bounds;

double magnitude(const Bounds& x) { return std::max(std::abs(x.low), std::abs(x.high)); }

/// The form with h takes longer, and is used if its bound is below this share of the other form's.
constexpr double kMomentGain = 0.25;

/// e, the bound on the error of h = f x g.
double moment_error(const FilteredSphere& sphere, const PlaneSizes& sizes, double rho) {
  const double u = std::abs(sphere.u), v = std::abs(sphere.v), w = std::abs(sphere.w);
  const double N = sizes.N, X = sizes.X, Y = sizes.Y;
  const auto of = [&, d = sizes.delta](double x, double y, double z, double t) {
    return kMomentRoundings * sizes.u0 * (x * y + z * t) + rho * (y + t) + d * (x + z) +
           2 * rho * d;
  };
  return kSlack * (of(v, N, w, Y) + of(w, X, u, N) + of(u, Y, v, X));
}

}  // namespace

PlaneSizes plane_sizes(const std::vector<Bounds>& alpha, const std::vector<Bounds>& beta,
                       const Bounds& near) {
  PlaneSizes sizes;
  sizes.N = magnitude(near);
  sizes.delta = half_width(near);
  for (const Bounds& x : alpha) {
    sizes.X = std::max(sizes.X, magnitude(x));
    sizes.delta = std::max(sizes.delta, half_width(x));
  }
  for (const Bounds& y : beta) {
    sizes.Y = std::max(sizes.Y, magnitude(y));
    sizes.delta = std::max(sizes.delta, half_width(y));
  }
  sizes.set_squares();
  return sizes;
}

void PlaneSizes::set_squares() {
  const double I_a = 2 * (N + X + Y) * delta + 3 * delta * delta;
  A = kSlack * (N * N + X * X + Y * Y + I_a);
  E_a = kSlack * (kSumRoundings * u0 * A + I_a);
}

SphereBound bound_of(const FilteredSphere& sphere, const SphereDoubt& doubt,
                     const PlaneSizes& sizes) {
  const auto& [u0, N, X, Y, delta, A, E_a] = sizes;
  const auto& [rho, rho_c, rho_r] = doubt;
  const double u = std::abs(sphere.u), v = std::abs(sphere.v), w = std::abs(sphere.w);
  const double c = std::abs(sphere.power);
  const double I_b = (N + X + Y) * rho + delta * (u + v + w + 3 * rho);
  const double B = kSlack * (N * w + Y * v + X * u + I_b);
  SphereBound bound;
  bound.E_b = kSlack * (kSumRoundings * u0 * B + I_b);
  bound.roots = 4 * u0 * (B + std::sqrt(B * B + c * A));
  bound.by_roots =
      kSlack * (kSquareShare * B * bound.E_b + kDiscRoundings * u0 * B * B +
                c * (kProductShare * E_a + kDiscRoundings * u0 * A) + kProductShare * rho_c * A);
  const double e = moment_error(sphere, sizes, rho);
  const double S = std::sqrt(sphere.radius_sq * A);
  bound.by_moment = kSlack * (4 * S * e + e * e + kByMomentRoundings * u0 * S * S +
                              sphere.radius_sq * kProductShare * E_a + kProductShare * rho_r * A);
  bound.has_moment = kLeastMoment * e <= S;
  return bound;
}

double SphereBound::root_margin(double E) const {
  return kSlack * (E_b + 1.02 * kRootShare * std::sqrt(E / kDecidedBeyond) + roots);
}

FilteredSphere filtered(const scene::SpherePlan& plan, std::size_t index, const PlaneSizes& sizes) {
  const scene::EyeSphere& seen = plan.seen;
  const Bounds radius_sq = square(seen.radius);
  FilteredSphere sphere;
  sphere.u = middle(seen.u);
  sphere.v = middle(seen.v);
  sphere.w = middle(seen.w);
  sphere.power = middle(seen.power);
  sphere.radius_sq = middle(radius_sq);
  sphere.index = static_cast<std::int32_t>(index);
  sphere.roots_matter = plan.origin_inside || plan.reaches_behind;
  const double rho = std::max({half_width(seen.u), half_width(seen.v), half_width(seen.w)});
  const SphereBound bound =
      bound_of(sphere, {rho, half_width(seen.power), half_width(radius_sq)}, sizes);
  set_bound(bound, bound.has_moment && bound.by_moment < kMomentGain * bound.by_roots, sphere);
  return sphere;
}

}  // namespace raycheck::reference
