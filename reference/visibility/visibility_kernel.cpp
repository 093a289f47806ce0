#include "reference/visibility/visibility_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "reference/visibility/visibility_kernel.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "reference/visibility/lanes.h"
#include "reference/visibility/visibility_formula.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::reference {
namespace HWY_NAMESPACE {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

HWY_INLINE Lanes all(D d, double x) { return {hn::Set(d, x)}; }
HWY_INLINE PairLanes all(D d, const Pair& x) { return {hn::Set(d, x.high), hn::Set(d, x.low)}; }

HWY_INLINE Lanes alpha_of(D d, const TileRays& rays, int column) {
  return {hn::LoadU(d, rays.alpha + column)};
}
HWY_INLINE PairLanes alpha_of(D d, const PairRays& rays, int column) {
  const PairLanes index{hn::Iota(d, rays.first_column + column), hn::Zero(d)};
  return mul_add(index, all(d, rays.step), all(d, rays.first));
}

HWY_INLINE Lanes load_numerators(D d, const Tile& tile, std::size_t at) {
  return {hn::Load(d, tile.numerator.data() + at)};
}
HWY_INLINE PairLanes load_numerators(D d, const PairTile& tile, std::size_t at) {
  return {hn::Load(d, tile.numerator.data() + at), hn::Load(d, tile.rest.data() + at)};
}
HWY_INLINE void store_numerators(D d, Lanes numerators, std::size_t at, Tile& tile) {
  hn::Store(numerators.high, d, tile.numerator.data() + at);
}
HWY_INLINE void store_numerators(D d, PairLanes numerators, std::size_t at, PairTile& tile) {
  hn::Store(numerators.high, d, tile.numerator.data() + at);
  hn::Store(numerators.low, d, tile.rest.data() + at);
}

/// Whether a column of the vector that begins at `column` is wanted.
HWY_INLINE bool any_wanted(const Tile& /*tile*/, int /*row*/, int /*column*/) { return true; }
HWY_INLINE bool any_wanted(const PairTile& tile, int row, int column) {
  const std::uint64_t from = tile.wanted[static_cast<std::size_t>(row)] >> column;
  return (from & ((std::uint64_t{1} << hn::Lanes(D())) - 1)) != 0;
}

HWY_INLINE void mark_undecided(D d, M undecided, int row, int column, Tile& tile) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, undecided, bits);
  tile.undecided[static_cast<std::size_t>(row)] |= std::uint64_t{bits[0]} << column;
}

/// A sphere's roots m = b -+ q on some lines, a = |g|^2, and the lines that meet it or may meet it.
template <class N>
struct Roots {
  N b, q, a;
  M met;
  M undecided;
};

/// The root that counts, and whether the sphere is certainly met there, in front.
template <class N>
struct Met {
  N numerator;
  M hit;
  M undecided;
};

template <Certified kCertified, class N, class Rays>
HWY_INLINE Met<N> choose_root(D d, const Roots<N>& roots, V root_margin, const Rays& rays) {
  const auto& [b, q, a, met, undecided] = roots;
  const N start = scaled(a, hn::Set(d, rays.start_factor));
  const V margin = kCertified == Certified::kYes
                       ? hn::Add(root_margin, hn::Set(d, rays.start_margin))
                       : hn::Zero(d);
  const N near_root = b - q, far_root = b + q;
  const V smaller = (near_root - start).high, larger = (far_root - start).high;
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
  return {select(smaller_in_front, near_root, far_root), hn::And(met, hit),
          kCertified == Certified::kYes ? hn::Or(undecided, hn::AndNot(decided, met)) : undecided};
}

enum class Answer { kNearest, kClass };

template <Certified kCertified, Answer kAnswer, bool kRootsMatter, bool kByMoment, class Number,
          class Rays, class SomeTile>
void sweep_sphere(const SphereInTileOf<Number>& entry, double margin_so_far, const Rays& rays,
                  SomeTile& tile) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const FilteredSphereOf<Number>& sphere = *entry.sphere;
  const V decided = hn::Set(d, kCertified == Certified::kYes ? sphere.decided : 0);
  const V root_margin = hn::Set(d, sphere.root_margin);
  const V order_margin = hn::Set(d, sphere.root_margin + margin_so_far);
  using N = decltype(all(d, sphere.u));
  const N u = all(d, sphere.u), v = all(d, sphere.v), w = all(d, sphere.w);
  const N power = all(d, sphere.power), radius_sq = all(d, sphere.radius_sq);
  const V here = hn::Set(d, sphere.index);
  const int first = entry.pixels.i_begin / lanes * lanes;
  const double hidden = hidden_below(entry.distance, margin_so_far, rays.least_length);
  const int first_run_end = tile.least_farthest < hidden ? 0 : entry.pixels.i_end;
  for (int row = entry.pixels.j_begin; row < entry.pixels.j_end; ++row) {
    const double* const farthest = tile.farthest.data() + row * Tile::kRuns;
    const RowTerms<N> terms =
        row_terms(all(d, rays.near), all(d, rays.beta[static_cast<std::size_t>(row)]), u, v, w);
    for (int column = first, run_end = first_run_end; column < entry.pixels.i_end;
         column += lanes) {
      if (column >= run_end) {
        const int run = column / Tile::kRun;
        run_end = (run + 1) * Tile::kRun;
        if (farthest[run] < hidden) {
          column = run_end - lanes;
          continue;
        }
      }
      if (!any_wanted(tile, row, column)) continue;
      const N alpha = alpha_of(d, rays, column);
      const N b = b_of(alpha, u, terms.b), a = a_of(alpha, terms.a);
      const N disc = kByMoment ? discriminant_by_moment(moment_of(alpha, v, w, terms), a, radius_sq)
                               : discriminant(b, a, power);
      M met = hn::Gt(disc.high, decided);
      M undecided = kCertified == Certified::kYes ? hn::Le(hn::Abs(disc.high), decided)
                                                  : hn::Lt(b.high, b.high);  // none
      if (hn::AllFalse(d, hn::Or(met, undecided))) continue;
      const std::size_t at = static_cast<std::size_t>(row * Tile::kWidth + column);
      N numerator = b;
      if (kAnswer == Answer::kNearest || kRootsMatter) {
        const N q = root_where(met, disc);
        if (kRootsMatter) {
          const Met<N> chosen =
              choose_root<kCertified, N>(d, {b, q, a, met, undecided}, root_margin, rays);
          numerator = chosen.numerator;
          met = chosen.hit;
          undecided = chosen.undecided;
        } else {
          numerator = b - q;
        }
      }
      if (kAnswer == Answer::kNearest) {
        const N nearest = load_numerators(d, tile, at);
        const V apart = (numerator - nearest).high;
        if (kCertified == Certified::kYes) {
          const M close = hn::Le(hn::Abs(apart), order_margin);
          undecided = hn::Or(undecided, hn::And(met, close));
        }
        met = hn::And(met, hn::Lt(apart, hn::Zero(d)));
        store_numerators(d, select(met, numerator, nearest), at, tile);
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
  const std::uint64_t columns = columns_of(pixels);
  for (int row = pixels.j_begin; row < pixels.j_end; ++row) {
    tile.undecided[static_cast<std::size_t>(row)] |= columns;
  }
}

/// Sweeps a sphere with its form of the discriminant (by_moment).
template <Certified kCertified, Answer kAnswer>
void sweep_by_form(const SphereInTile& entry, double margin_so_far, const TileRays& rays,
                   Tile& tile) {
  const FilteredSphere& sphere = *entry.sphere;
  if (kCertified == Certified::kYes && sphere.exact) return leave_to_exact(entry.pixels, tile);
  const auto sweep =
      sphere.roots_matter
          ? (sphere.by_moment
                 ? sweep_sphere<kCertified, kAnswer, true, true, double, TileRays, Tile>
                 : sweep_sphere<kCertified, kAnswer, true, false, double, TileRays, Tile>)
          : (sphere.by_moment
                 ? sweep_sphere<kCertified, kAnswer, false, true, double, TileRays, Tile>
                 : sweep_sphere<kCertified, kAnswer, false, false, double, TileRays, Tile>);
  sweep(entry, margin_so_far, rays, tile);
}

double set_farthest(Tile& tile) {
  const D d;
  V farthest = hn::Zero(d);
  tile.least_farthest = kInfinity;
  for (std::size_t run = 0; run < tile.farthest.size(); ++run) {
    V most = hn::Zero(d);
    for (std::size_t k = run * Tile::kRun; k < (run + 1) * Tile::kRun; k += hn::Lanes(d)) {
      most = hn::Max(most, hn::Load(d, tile.numerator.data() + k));
    }
    tile.farthest[run] = hn::GetLane(hn::MaxOfLanes(d, most));
    tile.least_farthest = std::min(tile.least_farthest, tile.farthest[run]);
    farthest = hn::Max(farthest, most);
  }
  return hn::GetLane(hn::MaxOfLanes(d, farthest));
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

void sweep_in_pairs(std::span<const SphereInTileOf<Pair>> spheres, const PairRays& rays,
                    PairTile& tile) {
  double margin = 0;
  for (const SphereInTileOf<Pair>& entry : spheres) {
    if (entry.sphere->exact) {
      leave_to_exact(entry.pixels, tile);
      continue;
    }
    sweep_sphere<Certified::kYes, Answer::kNearest, true, true>(entry, margin, rays, tile);
    margin = std::max(margin, entry.sphere->root_margin);
  }
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
      const V t = hn::Div(m, l), lengths = hn::Set(d, scale.lengths);
      if (output.parameter != nullptr) {
        store_first(d, hn::Sub(hn::Mul(t, lengths), hn::Mul(l, hn::Set(d, scale.plane))), count,
                    output.parameter + to);
      }
      if (!with_points) continue;
      const V along = hn::Div(t, l);
      for (std::size_t k = 0; k < 3; ++k) {
        const V row_g = hn::Set(d, rays.near * scale.W[k] + beta * scale.V[k]);
        const V g = hn::MulAdd(alpha, hn::Set(d, scale.U[k]), row_g);
        const V point = hn::MulAdd(hn::Mul(along, g), lengths, hn::Set(d, scale.eye[k]));
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
HWY_EXPORT(sweep_in_pairs);
HWY_EXPORT(sweep_class);
HWY_EXPORT(set_farthest);
HWY_EXPORT(finish_tile);

std::int64_t kernel_targets() { return HWY_TARGETS; }

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
  tile.farthest.fill(kInfinity);
  tile.least_farthest = kInfinity;
}

void clear(PairTile& tile, const std::array<std::uint64_t, Tile::kHeight>& wanted) {
  tile.undecided.fill(0);
  tile.least_farthest = std::numeric_limits<double>::infinity();
  tile.wanted = wanted;
  for (std::size_t row = 0; row < wanted.size(); ++row) {
    if (wanted[row] == 0) continue;
    const std::size_t at = row * Tile::kWidth;
    std::fill_n(tile.numerator.data() + at, Tile::kWidth, std::numeric_limits<double>::max());
    std::fill_n(tile.rest.data() + at, Tile::kWidth, 0.0);
    std::fill_n(tile.sphere.data() + at, Tile::kWidth, -1.0);
  }
}

void sweep(std::span<const SphereInTileOf<Pair>> spheres, const PairRays& rays, PairTile& tile) {
  HWY_DYNAMIC_DISPATCH(sweep_in_pairs)(spheres, rays, tile);
}

void sweep(std::span<const SphereInTile> spheres, const TileRays& rays, Certified certified,
           Tile& tile, double& margin) {
  if (certified == Certified::kYes) {
    HWY_DYNAMIC_DISPATCH(sweep_certified)(spheres, rays, tile, margin);
  } else {
    HWY_DYNAMIC_DISPATCH(sweep_uncertified)(spheres, rays, tile, margin);
  }
}

double set_farthest(Tile& tile) { return HWY_DYNAMIC_DISPATCH(set_farthest)(tile); }

double hidden_below(double distance, double margin, double least_length) {
  // For all pixels t l > m; 2^-40 covers the roundings here.
  return distance * least_length * (1 - 0x1p-40) - 2 * margin;
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
