#include "reference/visibility/visibility_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace raycheck::reference {
namespace {

using scene::Bounds;

double magnitude(const Bounds& x) { return std::max(std::abs(x.low), std::abs(x.high)); }

constexpr double kUnitRoundoff = 0x1p-53;
/// The form by h takes longer: only where its bound is so much smaller.
constexpr double kMomentGain = 0.25;

/// e of h = f x g.
double moment_error(const FilteredSphere& sphere, const PlaneSizes& sizes, double rho) {
  const double u = std::abs(sphere.u), v = std::abs(sphere.v), w = std::abs(sphere.w);
  const auto& [N, X, Y, delta, A, E_a] = sizes;
  const auto of = [&, d = delta](double x, double y, double z, double t) {
    return kMomentRoundings * kUnitRoundoff * (x * y + z * t) + rho * (y + t) + d * (x + z) +
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
  const double I_a =
      2 * (sizes.N + sizes.X + sizes.Y) * sizes.delta + 3 * sizes.delta * sizes.delta;
  sizes.A = kSlack * (sizes.N * sizes.N + sizes.X * sizes.X + sizes.Y * sizes.Y + I_a);
  sizes.E_a = kSlack * (kSumRoundings * kUnitRoundoff * sizes.A + I_a);
  return sizes;
}

FilteredSphere filtered(const scene::SpherePlan& plan, std::size_t index, const PlaneSizes& sizes) {
  FilteredSphere sphere;
  sphere.u = middle(plan.seen.u);
  sphere.v = middle(plan.seen.v);
  sphere.w = middle(plan.seen.w);
  sphere.power = middle(plan.seen.power);
  sphere.index = static_cast<std::int32_t>(index);
  sphere.roots_matter = plan.origin_inside || plan.reaches_behind;
  const auto& [N, X, Y, delta, A, E_a] = sizes;
  const double rho =
      std::max({half_width(plan.seen.u), half_width(plan.seen.v), half_width(plan.seen.w)});
  const double u = std::abs(sphere.u), v = std::abs(sphere.v), w = std::abs(sphere.w);
  const double c = std::abs(sphere.power);
  const double I_b = (N + X + Y) * rho + delta * (u + v + w + 3 * rho);
  const double B = kSlack * (N * w + Y * v + X * u + I_b);
  const double E_b = kSlack * (kSumRoundings * kUnitRoundoff * B + I_b);
  const double by_roots =
      kSlack * (kSquareShare * B * E_b + kDiscRoundings * kUnitRoundoff * B * B +
                c * (kProductShare * E_a + kDiscRoundings * kUnitRoundoff * A) +
                kProductShare * half_width(plan.seen.power) * A);
  const double e = moment_error(sphere, sizes, rho);
  const Bounds radius_sq = square(plan.seen.radius);
  sphere.radius_sq = middle(radius_sq);
  const double S = std::sqrt(sphere.radius_sq * A);
  const double by_moment =
      kSlack * (4 * S * e + e * e + kByMomentRoundings * kUnitRoundoff * S * S +
                sphere.radius_sq * kProductShare * E_a + kProductShare * half_width(radius_sq) * A);
  sphere.by_moment = kLeastMoment * e <= S && by_moment < kMomentGain * by_roots;
  const double E = sphere.by_moment ? by_moment : by_roots;
  sphere.decided = kDecidedBeyond * E;
  sphere.root_margin = kSlack * (E_b + 1.02 * kRootShare * std::sqrt(E / kDecidedBeyond) +
                                 4 * kUnitRoundoff * (B + std::sqrt(B * B + c * A)));
  sphere.exact = !(E >= kLeastBound && sphere.decided <= kLargestBound);
  return sphere;
}

}  // namespace raycheck::reference
