#pragma once

// The filter of certified visibility. It tests a tile of pixels against spheres, front to back, in
// vectors of doubles as wide as the machine's. Every decision allows for a bound on its error.
// Internal to reference/; it shares no code with candidates.
//
// From the eye, let g = n W + alpha U + beta V and a = |g|^2 = n^2 + alpha^2 + beta^2. With f = C -
// E = (u, v, w) along the camera's axes, let b = f.g = n w + beta v + alpha u and c = |f|^2 - r^2.
// The line E + lambda g meets the sphere at the roots lambda = (b -+ q)/a, q = sqrt(disc), disc =
// b^2 - c a. The numerators m = b -+ q order the spheres of one pixel; m = t l, where t = |Q - E|,
// l = sqrt(a).
//
// The bound holds for all pixels of an image; its roundings are proved in proofs/. ^ marks computed
// values, and u0 = 2^-53 is the unit roundoff. n, alpha, beta are known to within delta, u, v, w to
// within rho, c to within rho_c (half widths of scene::EyeSpace's bounds). N, X, Y, |u|, |v|, |w|
// bound their magnitudes.
//   B  = N|w| + Y|v| + X|u| + I_b,  I_b = (N + Y + X) rho + delta (|u| + |v| + |w| + 3 rho):
//        |b|, |b^| < 1.01 B and |b^ - b| <= E_b = 5 u0 B + I_b
//   A  = N^2 + X^2 + Y^2 + I_a,  I_a = 2 (N + X + Y) delta + 3 delta^2:
//        |a^ - a| <= E_a = 5 u0 A + I_a
//   |disc^ - disc| <= E, where
//   E  = 2.2 B E_b + 3.1 u0 B^2 + |c^| (1.1 E_a + 3.1 u0 A) + 1.1 rho_c A:
//        b^b^ is off by E_b (|b^| + |b|), c^a^ by |c^| E_a + rho_c A, and three roundings follow.
// If r is much smaller than |f|, both terms of disc are larger than disc by |f|^2/r^2. Then the
// form disc = r^2 a - |h|^2, h = f x g, is better. Let R^2 be the computed r^2, known to within
// rho_r, and
//   e  = e_1 + e_2 + e_3, e_k = 3 u0 P_k + I_k, for the component x y - z t of h with
//        P_k = |x||y| + |z||t| and I_k = rho (|y| + |t|) + delta (|x| + |z|) + 2 rho delta:
//        |h^ - h| <= e
//   S  = sqrt(R^2 A)
//   E  = 4 S e + e^2 + 33 u0 S^2 + R^2 1.1 E_a + 1.1 rho_r A:
//        |h|^2 is off by 2 |h| e + e^2, r^2 a like c a above, and seven roundings follow.
// This bound holds if |h| <= 2 S. Otherwise disc < -3 S^2, and with e <= S/8, disc^ < -2 S^2: the
// ray misses, and is not taken for a hit. For each sphere the form with the smaller E is used.
//
// The sign of disc^ is certain if |disc^| > kDecidedBeyond E. If it is positive, disc is above
// (kDecidedBeyond - 1) E, so that q^ is off by at most E / (2 sqrt((kDecidedBeyond - 1) E)) < 0.51
// sqrt(E / kDecidedBeyond) and its rounding, and
//   |m^ - m| <= E_m = E_b + 0.52 sqrt(E / kDecidedBeyond) + 4 u0 (B + sqrt(B^2 + |c^| A)).
// The order of two numerators of one pixel is certain if they differ by more than the sum of their
// E_m. A root is certainly in front of or behind the origin (lambda = 1; 0 for focal rays) if m^
// differs from a^ (or 0) by more than E_m + 2 E_a. Underflow adds less than 2^-1000, which is
// negligible if E is at least kLeastBound. Nothing overflows if E is at most kLargestBound. The
// bounds are computed in doubles, too, with 1% to spare.
//
// Pixels that doubles leave undecided are swept again in double-doubles, with h for every sphere.
// The bound is the same with u0 = kDoubleDoubleError, which bounds the error of each operation, and
// with delta and rho from the numbers in double-doubles (visibility_pairs.h). They are used for
// scenes that need no scaling (scene::kPlainExponent), so that nothing overflows. Spheres with e >
// S/8 are left to the exact ray.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace raycheck::reference {

inline constexpr double kDecidedBeyond = 0x1p6;
inline constexpr double kLeastBound = 0x1p-900;
inline constexpr double kLargestBound = 0x1p900;

struct Pair {
  double high = 0, low = 0;
};

/// A sphere as the filter stores it, in doubles or in pairs. The comment above explains the names.
template <class Number>
struct FilteredSphereOf {
  Number u{}, v{}, w{};
  Number power{};            ///< c
  Number radius_sq{};        ///< R^2
  double decided = 0;        ///< kDecidedBeyond E
  double root_margin = 0;    ///< E_m
  std::int32_t index = 0;    ///< Its index in the scene.
  bool roots_matter = true;  ///< Not every line that meets it does so in front, at b - q.
  bool by_moment = false;    ///< The form disc = r^2 a - |f x g|^2 is used.
  bool exact = false;        ///< No bound holds, so that the filter leaves its pixels undecided.
};
using FilteredSphere = FilteredSphereOf<double>;

/// A part of a tile. Rows and columns count from the tile's first.
struct TileRectangle {
  int i_begin = 0, i_end = 0, j_begin = 0, j_end = 0;
  int count() const { return (i_end - i_begin) * (j_end - j_begin); }
};
/// The columns of a rectangle, one bit each.
inline std::uint64_t columns_of(const TileRectangle& pixels) {
  const auto before = [](int end) {
    return end == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << end) - 1;
  };
  return before(pixels.i_end) & ~before(pixels.i_begin);
}

template <class Number>
struct SphereInTileOf {
  const FilteredSphereOf<Number>* sphere = nullptr;
  TileRectangle pixels;
  double distance = 0;  ///< A lower bound on the distance from the eye to a hit.
};
using SphereInTile = SphereInTileOf<double>;

struct Tile {
  static constexpr int kWidth = 64;
  static constexpr int kHeight = 16;
  static constexpr int kPixels = kWidth * kHeight;
  static constexpr int kRun = 16;              ///< Pixels of a row that are skipped together.
  static constexpr int kRuns = kWidth / kRun;  ///< The runs of a row.
  static constexpr int kAllRuns = kHeight * kRuns;

  alignas(64) std::array<double, kPixels> numerator;  ///< m^ of the nearest so far, or infinity.
  alignas(64) std::array<double, kPixels> sphere;     ///< The nearest sphere so far, or -1.
  std::array<std::uint64_t, kHeight> undecided;       ///< One bit per column.
  /// An upper bound on the numerators of each run, and the least of these bounds. Set by
  /// set_farthest().
  std::array<double, kAllRuns> farthest;
  double least_farthest;
};
/// A tile in pairs, of which some pixels are wanted.
struct PairTile : Tile {
  alignas(64) std::array<double, kPixels> rest;  ///< The low parts of numerators.
  std::array<std::uint64_t, kHeight> wanted;     ///< The wanted pixels, one bit per column.
};

/// The terms that the rays of a tile share. The alpha of its columns are in the derived structs.
template <class Number>
struct TileRaysOf {
  std::array<Number, Tile::kHeight> beta{};
  Number near{};            ///< n^
  double start_factor = 0;  ///< A root is in front if m >= start_factor a; 0 for focal rays.
  double start_margin = 0;  ///< 2 start_factor E_a
  double least_length = 0;  ///< A lower bound on l.
  bool larger_counts = true;
};
struct TileRays : TileRaysOf<double> {
  const double* alpha = nullptr;  ///< kWidth numbers.
};
/// alpha = first + column step
struct PairRays : TileRaysOf<Pair> {
  Pair first, step;
  double first_column = 0;
};

enum class Certified { kNo, kYes };

/// The targets of Highway that the kernel is compiled for.
std::int64_t kernel_targets();

/// Resets the tile: no sphere, all pixels decided. Pixels outside the wanted rectangle get a
/// numerator below those of all spheres.
void clear(Tile& tile, const TileRectangle& wanted);
/// Resets the wanted pixels to no sphere.
void clear(PairTile& tile, const std::array<std::uint64_t, Tile::kHeight>& wanted);

/// Sweeps spheres over the tile. All pixels that are not undecided then have the nearest sphere so
/// far. `margin` is the largest E_m so far.
void sweep(std::span<const SphereInTile> spheres, const TileRays& rays, Certified certified,
           Tile& tile, double& margin);
/// Sweeps spheres, certified, over the wanted pixels of a tile in pairs.
void sweep(std::span<const SphereInTileOf<Pair>> spheres, const PairRays& rays, PairTile& tile);
/// Finds the hit class of one sphere at all pixels of the tile; numerators do not change.
void sweep_class(const SphereInTile& sphere, const TileRays& rays, Tile& tile);
/// Sets `farthest` from the numerators so far, and returns the largest.
double set_farthest(Tile& tile);
/// A pixel with a numerator below the result, which is off by at most `margin`, has met a sphere at
/// a t below `distance`.
double hidden_below(double distance, double margin, double least_length);

/// The arrays to which a tile's answers are written, from its first pixel on; null: not wanted.
struct TileOutput {
  std::int32_t* sphere = nullptr;
  double* parameter = nullptr;
  std::array<double*, 3> point{};
  std::ptrdiff_t stride = 0;  ///< The distance from one row to the next.
};
/// Converts numerators to lengths: t = m/l, s = t 2^lengths - l 2^plane (for focal rays, s = t
/// 2^lengths), Q = E + (t/l) g 2^lengths. A result that a power of two makes subnormal is rounded
/// once.
struct TileScale {
  double lengths = 1;
  double plane = 1;  ///< 0 for focal rays.
  std::array<double, 3> eye{}, U{}, V{}, W{};
};
/// Writes the wanted pixels, which are some rows of the first columns. Returns their least
/// numerator; infinity if no sphere is met.
double finish_tile(const Tile& tile, const TileRectangle& wanted, const TileRays& rays,
                   const TileScale& scale, const TileOutput& output);

}  // namespace raycheck::reference
