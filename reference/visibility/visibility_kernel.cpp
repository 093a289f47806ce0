#include "reference/visibility/visibility_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "reference/visibility/visibility_kernel.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "reference/visibility/visibility_formula.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::reference {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A number of visibility_formula.h.
struct Lanes {
  V raw;
};
HWY_INLINE Lanes operator*(Lanes x, Lanes y) { return {hn::Mul(x.raw, y.raw)}; }
HWY_INLINE Lanes mul_add(Lanes x, Lanes y, Lanes z) { return {hn::MulAdd(x.raw, y.raw, z.raw)}; }
HWY_INLINE Lanes mul_sub(Lanes x, Lanes y, Lanes z) { return {hn::MulSub(x.raw, y.raw, z.raw)}; }
HWY_INLINE Lanes sub_mul(Lanes x, Lanes y, Lanes z) { return {hn::NegMulAdd(x.raw, y.raw, z.raw)}; }

HWY_INLINE void mark_undecided(D d, M undecided, int row, int column, Tile& tile) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, undecided, bits);
  tile.undecided[static_cast<std::size_t>(row)] |= std::uint64_t{bits[0]} << column;
}

/// A sphere's roots m = b -+ q on some lines, a = |g|^2, and which lines meet it, or may.
struct Roots {
  V b, q, a;
  M met;
  M undecided;
};

/// The root that counts; whether the sphere is certainly met there, in front.
struct Met {
  V numerator;
  M hit;
  M undecided;
};

template <Certified kCertified>
HWY_INLINE Met choose_root(D d, const Roots& roots, V root_margin, const TileRays& rays) {
  const auto& [b, q, a, met, undecided] = roots;
  const V start = hn::Mul(hn::Set(d, rays.start_factor), a);
  const V margin = kCertified == Certified::kYes
                       ? hn::Add(root_margin, hn::Set(d, rays.start_margin))
                       : hn::Zero(d);
  const V smaller = hn::Sub(hn::Sub(b, q), start);
  const V larger = hn::Sub(hn::Add(b, q), start);
  const M smaller_in_front =
      kCertified == Certified::kYes ? hn::Gt(smaller, margin) : hn::Ge(smaller, margin);
  const M larger_in_front =
      kCertified == Certified::kYes ? hn::Gt(larger, margin) : hn::Ge(larger, margin);
  const M smaller_behind = hn::Lt(smaller, hn::Neg(margin));
  const M larger_behind = hn::Lt(larger, hn::Neg(margin));
  M hit = smaller_in_front;
  M decided = hn::Or(smaller_in_front, smaller_behind);
  if (rays.larger_counts) {
    hit = hn::Or(hit, hn::And(smaller_behind, larger_in_front));
    decided =
        hn::Or(smaller_in_front, hn::And(smaller_behind, hn::Or(larger_in_front, larger_behind)));
  }
  return {hn::IfThenElse(smaller_in_front, hn::Sub(b, q), hn::Add(b, q)), hn::And(met, hit),
          kCertified == Certified::kYes ? hn::Or(undecided, hn::AndNot(decided, met)) : undecided};
}

enum class Answer { kNearest, kClass };

template <Certified kCertified, Answer kAnswer, bool kRootsMatter, bool kByMoment>
void sweep_sphere(const SphereInTile& entry, double margin_so_far, const TileRays& rays,
                  Tile& tile) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const FilteredSphere& sphere = *entry.sphere;
  const V decided = hn::Set(d, kCertified == Certified::kYes ? sphere.decided : 0);
  const V root_margin = hn::Set(d, sphere.root_margin);
  const V order_margin = hn::Set(d, sphere.root_margin + margin_so_far);
  const auto all = [d](double x) { return Lanes{hn::Set(d, x)}; };
  const Lanes u = all(sphere.u), v = all(sphere.v), w = all(sphere.w);
  const Lanes power = all(sphere.power), radius_sq = all(sphere.radius_sq);
  const V here = hn::Set(d, sphere.index);
  const int first = entry.pixels.i_begin / lanes * lanes;
  for (int row = entry.pixels.j_begin; row < entry.pixels.j_end; ++row) {
    const double beta = rays.beta[static_cast<std::size_t>(row)];
    const RowTerms<double> shared = row_terms(rays.near, beta, sphere.u, sphere.v, sphere.w);
    const RowTerms<Lanes> terms = {all(shared.b), all(shared.a), all(shared.moment),
                                   all(shared.n_u), all(shared.beta_u)};
    for (int column = first; column < entry.pixels.i_end; column += lanes) {
      const Lanes alpha{hn::LoadU(d, rays.alpha + column)};
      const Lanes line_b = b_of(alpha, u, terms.b), line_a = a_of(alpha, terms.a);
      const V b = line_b.raw, a = line_a.raw;
      const V disc =
          (kByMoment ? discriminant_by_moment(moment_of(alpha, v, w, terms), line_a, radius_sq)
                     : discriminant(line_b, line_a, power))
              .raw;
      M met = hn::Gt(disc, decided);
      M undecided =
          kCertified == Certified::kYes ? hn::Le(hn::Abs(disc), decided) : hn::Lt(b, b);  // none
      if (hn::AllFalse(d, hn::Or(met, undecided))) continue;
      const std::size_t at = static_cast<std::size_t>(row * Tile::kWidth + column);
      V numerator = b;
      if (kAnswer == Answer::kNearest || kRootsMatter) {
        const V q = hn::Sqrt(hn::IfThenElseZero(met, disc));
        if (kRootsMatter) {
          const Met chosen =
              choose_root<kCertified>(d, {b, q, a, met, undecided}, root_margin, rays);
          numerator = chosen.numerator;
          met = chosen.hit;
          undecided = chosen.undecided;
        } else {
          numerator = hn::Sub(b, q);
        }
      }
      if (kAnswer == Answer::kNearest) {
        const V nearest = hn::Load(d, tile.numerator.data() + at);
        if (kCertified == Certified::kYes) {
          const M close = hn::Le(hn::Abs(hn::Sub(numerator, nearest)), order_margin);
          undecided = hn::Or(undecided, hn::And(met, close));
        }
        met = hn::And(met, hn::Lt(numerator, nearest));
        hn::Store(hn::IfThenElse(met, numerator, nearest), d, tile.numerator.data() + at);
      }
      double* const seen = tile.sphere.data() + at;
      hn::Store(hn::IfThenElse(met, here, hn::Load(d, seen)), d, seen);
      if (kCertified == Certified::kYes && HWY_UNLIKELY(!hn::AllFalse(d, undecided))) {
        mark_undecided(d, undecided, row, column, tile);
      }
    }
  }
}

void leave_to_exact(const TileRectangle& pixels, Tile& tile) {
  const std::uint64_t below_end =
      pixels.i_end == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << pixels.i_end) - 1;
  const std::uint64_t columns = below_end & ~((std::uint64_t{1} << pixels.i_begin) - 1);
  for (int row = pixels.j_begin; row < pixels.j_end; ++row) {
    tile.undecided[static_cast<std::size_t>(row)] |= columns;
  }
}

/// Sweeps a sphere in the form that suits it.
template <Certified kCertified, Answer kAnswer>
void sweep_by_form(const SphereInTile& entry, double margin_so_far, const TileRays& rays,
                   Tile& tile) {
  const FilteredSphere& sphere = *entry.sphere;
  if (kCertified == Certified::kYes && sphere.exact) return leave_to_exact(entry.pixels, tile);
  const auto sweep = sphere.roots_matter
                         ? (sphere.by_moment ? sweep_sphere<kCertified, kAnswer, true, true>
                                             : sweep_sphere<kCertified, kAnswer, true, false>)
                         : (sphere.by_moment ? sweep_sphere<kCertified, kAnswer, false, true>
                                             : sweep_sphere<kCertified, kAnswer, false, false>);
  sweep(entry, margin_so_far, rays, tile);
}

bool all_nearer(const Tile& tile, double margin, const TileRays& rays, double distance) {
  const D d;
  // t l > m of all pixels: 2^-40 covers these roundings.
  const V least = hn::Set(d, distance * rays.least_length * (1 - 0x1p-40));
  const V doubt = hn::Set(d, 2 * margin);
  for (std::size_t row = 0; row < tile.numerator.size(); row += Tile::kWidth) {
    V most = hn::Zero(d);
    for (std::size_t k = row; k < row + Tile::kWidth; k += hn::Lanes(d)) {
      most = hn::Max(most, hn::Load(d, tile.numerator.data() + k));
    }
    if (!hn::AllTrue(d, hn::Gt(least, hn::Add(most, doubt)))) return false;
  }
  return true;
}

template <Certified kCertified>
void sweep_all(std::span<const SphereInTile> spheres, const TileRays& rays, Tile& tile,
               double& margin) {
  for (const SphereInTile& entry : spheres) {
    sweep_by_form<kCertified, Answer::kNearest>(entry, margin, rays, tile);
    if (!entry.sphere->exact) margin = std::max(margin, entry.sphere->root_margin);
  }
}

void sweep_certified(std::span<const SphereInTile> spheres, const TileRays& rays, Tile& tile,
                     double& margin) {
  sweep_all<Certified::kYes>(spheres, rays, tile, margin);
}
void sweep_uncertified(std::span<const SphereInTile> spheres, const TileRays& rays, Tile& tile,
                       double& margin) {
  sweep_all<Certified::kNo>(spheres, rays, tile, margin);
}

void sweep_class(const SphereInTile& entry, const TileRays& rays, Tile& tile) {
  sweep_by_form<Certified::kYes, Answer::kClass>(entry, 0, rays, tile);
}

HWY_INLINE void store_first(D d, V values, int count, double* to) {
  if (count >= static_cast<int>(hn::Lanes(d))) {
    hn::StoreU(values, d, to);
  } else {
    alignas(64) double lanes[8];
    hn::Store(values, d, lanes);
    std::copy_n(lanes, count, to);
  }
}

HWY_INLINE void store_first_spheres(D d, const double* spheres, int count, std::int32_t* to) {
  const hn::Rebind<std::int32_t, D> d32;
  const auto indices = hn::DemoteTo(d32, hn::Load(d, spheres));
  if (count >= static_cast<int>(hn::Lanes(d))) {
    hn::StoreU(indices, d32, to);
  } else {
    alignas(32) std::int32_t part[8];
    hn::Store(indices, d32, part);
    std::copy_n(part, count, to);
  }
}

double finish_tile(const Tile& tile, const TileRectangle& wanted, const TileRays& rays,
                   const TileScale& scale, const TileOutput& output) {
  const D d;
  const int columns = wanted.i_end;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const bool with_points = output.point[0] != nullptr;
  const V nothing = hn::Set(d, kInfinity);
  V least = nothing;
  for (int row = wanted.j_begin; row < wanted.j_end; ++row) {
    const double beta = rays.beta[static_cast<std::size_t>(row)];
    const V row_a = hn::Set(d, rays.near * rays.near + beta * beta);
    const std::ptrdiff_t row_at = (row - wanted.j_begin) * output.stride;
    for (int column = 0; column < columns; column += lanes) {
      const std::size_t at = static_cast<std::size_t>(row * Tile::kWidth + column);
      const std::ptrdiff_t to = row_at + column;
      const int count = std::min(lanes, columns - column);
      if (output.sphere != nullptr) {
        store_first_spheres(d, tile.sphere.data() + at, count, output.sphere + to);
      }
      if (output.parameter == nullptr && !with_points) continue;
      const V m = hn::Load(d, tile.numerator.data() + at);
      if (hn::AllTrue(d, hn::Eq(m, nothing))) {
        if (output.parameter != nullptr) store_first(d, nothing, count, output.parameter + to);
        for (double* const point : output.point) {
          if (point != nullptr) store_first(d, nothing, count, point + to);
        }
        continue;
      }
      least = hn::Min(least, m);
      const V alpha = hn::LoadU(d, rays.alpha + column);
      const V l = hn::Sqrt(hn::MulAdd(alpha, alpha, row_a));
      const V t = hn::Mul(hn::Div(m, l), hn::Set(d, scale.lengths));
      if (output.parameter != nullptr) {
        store_first(d, hn::Sub(t, hn::Mul(l, hn::Set(d, scale.plane))), count,
                    output.parameter + to);
      }
      if (!with_points) continue;
      const V along = hn::Div(t, l);
      for (std::size_t k = 0; k < 3; ++k) {
        const V row_g = hn::Set(d, rays.near * scale.W[k] + beta * scale.V[k]);
        const V g = hn::MulAdd(alpha, hn::Set(d, scale.U[k]), row_g);
        const V point = hn::MulAdd(along, g, hn::Set(d, scale.eye[k]));
        store_first(d, hn::IfThenElse(hn::Eq(m, nothing), nothing, point), count,
                    output.point[k] + to);
      }
    }
  }
  return hn::GetLane(hn::MinOfLanes(d, least));
}

}  // namespace HWY_NAMESPACE
}  // namespace raycheck::reference
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::reference {

HWY_EXPORT(sweep_certified);
HWY_EXPORT(sweep_uncertified);
HWY_EXPORT(sweep_class);
HWY_EXPORT(all_nearer);
HWY_EXPORT(finish_tile);

void clear(Tile& tile, const TileRectangle& wanted) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (wanted.j_begin == 0 && wanted.j_end == Tile::kHeight && wanted.i_end == Tile::kWidth) {
    tile.numerator.fill(kInfinity);
  } else {
    tile.numerator.fill(-kInfinity);
    for (int row = wanted.j_begin; row < wanted.j_end; ++row) {
      std::fill_n(tile.numerator.begin() + row * Tile::kWidth, wanted.i_end, kInfinity);
    }
  }
  tile.sphere.fill(-1);
  tile.undecided.fill(0);
}

void sweep(std::span<const SphereInTile> spheres, const TileRays& rays, Certified certified,
           Tile& tile, double& margin) {
  if (certified == Certified::kYes) {
    HWY_DYNAMIC_DISPATCH(sweep_certified)(spheres, rays, tile, margin);
  } else {
    HWY_DYNAMIC_DISPATCH(sweep_uncertified)(spheres, rays, tile, margin);
  }
}

bool all_nearer(const Tile& tile, double margin, const TileRays& rays, double distance) {
  return HWY_DYNAMIC_DISPATCH(all_nearer)(tile, margin, rays, distance);
}

void sweep_class(const SphereInTile& sphere, const TileRays& rays, Tile& tile) {
  HWY_DYNAMIC_DISPATCH(sweep_class)(sphere, rays, tile);
}

double finish_tile(const Tile& tile, const TileRectangle& wanted, const TileRays& rays,
                   const TileScale& scale, const TileOutput& output) {
  return HWY_DYNAMIC_DISPATCH(finish_tile)(tile, wanted, rays, scale, output);
}

}  // namespace raycheck::reference
#endif  // HWY_ONCE
