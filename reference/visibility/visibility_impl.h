#pragma once

// The data that Visibility stores for a scene, and the loop of its functions over bands and tiles.
// Internal to reference/.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "reference/exact_camera.h"
#include "reference/visibility/visibility.h"
#include "reference/visibility/visibility_bound.h"
#include "reference/visibility/visibility_kernel.h"
#include "reference/visibility/visibility_pairs.h"

namespace raycheck::reference {

/// The lists of all bands (or tiles) in one array. List k has items[begin[k]] up to, but without,
/// items[begin[k + 1]].
struct Lists {
  std::vector<std::uint32_t> items;
  std::vector<std::size_t> begin;

  std::span<const std::uint32_t> of(std::size_t k) const {
    return std::span(items).subspan(begin[k], begin[k + 1] - begin[k]);
  }
};

/// Sorts `count` items into lists, in order; item(k) is added to the lists in places(k).
template <class Places, class Item>
void distribute(std::size_t count, std::size_t lists, const Places& places, const Item& item,
                Lists& result) {
  result.begin.assign(lists + 1, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const auto [first, last] = places(k);
    for (std::size_t list = first; list < last; ++list) ++result.begin[list + 1];
  }
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  result.items.resize(result.begin.back());
  std::vector<std::size_t> next(result.begin.begin(), result.begin.end() - 1);
  for (std::size_t k = 0; k < count; ++k) {
    const auto [first, last] = places(k);
    for (std::size_t list = first; list < last; ++list) result.items[next[list]++] = item(k);
  }
}

/// The blocks of a given size that [begin, end) touches: the first, and one past the last.
struct Blocks {
  std::uint32_t first = 0, last = 0;
};
inline Blocks blocks(std::int64_t begin, std::int64_t end, int size) {
  return {static_cast<std::uint32_t>(begin / size),
          static_cast<std::uint32_t>((end - 1) / size + 1)};
}

/// The sort key of a sphere: its nearest distance as a float, rounded down, with the last
/// kDistanceRounds bits cleared.
float no_farther(double distance);
inline constexpr int kDistanceRounds = 12;

struct Visibility::Impl {
  Impl(scene::Scene its_scene, scene::ScenePlan its_plan);

  /// A planned sphere as the filter stores it.
  FilteredSphere filtered_of(const scene::SpherePlan& planned, std::size_t index) const;
  /// The camera in double-doubles, made when it is first needed; null if it is not used.
  const PairView* pair_view() const;

  scene::Scene scene;
  scene::ScenePlan plan;
  ExactCamera camera;
  std::int64_t width, height;
  PlaneSizes sizes;
  std::vector<double> alpha, beta;  ///< alpha is padded to whole tiles.
  double near;
  double start_factor;
  TileScale scale;
  double axis_doubt = 0;    ///< The largest half width of U, V, W in world coordinates.
  bool scales_fit = false;  ///< Lengths that are not scaled stay in the range of doubles.
  /// The spheres as the filter stores them, only for scenes of few spheres, which many tiles share.
  /// Of many spheres most are never swept.
  std::vector<FilteredSphere> kept;
  /// The spheres that may be visible in each band, by nearest distance, from the end of the
  /// previous reach to reach_end[reach]. Of many spheres most are hidden, so that a reach is listed
  /// only when it is needed.
  const Lists& bands(std::size_t reach) const;
  static constexpr std::size_t kReaches = 6;
  std::array<double, kReaches> reach_end{};  ///< Infinite from some element on.

  std::size_t band_count() const { return static_cast<std::size_t>((height - 1) / kBandRows + 1); }
  /// The number of tiles in a band.
  std::size_t tile_count() const {
    return static_cast<std::size_t>((width - 1) / Tile::kWidth + 1);
  }

 private:
  static constexpr std::size_t kMostKept = 16384;

  mutable std::once_flag pair_view_made_;
  mutable std::optional<PairView> pair_view_;
  mutable std::array<std::once_flag, kReaches> bands_made_;
  mutable std::array<Lists, kReaches> bands_;

  Blocks bands_of(std::size_t sphere) const;

  void set_plane();
  /// Throws std::invalid_argument if the lists would have more than kMostVisibleParts entries.
  void require_few_parts() const;
  void set_reaches();
  /// Lists the spheres whose distance is in [from, to).
  Lists list_bands(double from, double to) const;
};

/// Some rows of the image, divided into bands of kBandRows rows, and these into tiles.
class RowsInTiles {
 public:
  /// Throws std::invalid_argument if the image lacks these rows.
  RowsInTiles(const Visibility::Impl& impl, std::int64_t j_begin, std::int64_t j_end);

  std::size_t pixels() const { return static_cast<std::size_t>((j_end_ - j_begin_) * impl_.width); }
  /// Throws std::invalid_argument unless an array of this size is empty or has an element for each
  /// pixel.
  void require_fit(std::size_t size) const;

  /// Calls body(band) for one band after the other, which is then the current band.
  template <class Body>
  void for_each_band(Body body) {
    for (std::int64_t j = j_begin_ / Visibility::kBandRows * Visibility::kBandRows; j < j_end_;
         j += Visibility::kBandRows) {
      row_begin_ = static_cast<int>(std::max(j, j_begin_) - j);
      row_end_ = static_cast<int>(std::min(j + Visibility::kBandRows, j_end_) - j);
      first_row_ = j;
      body(static_cast<std::size_t>(j / Visibility::kBandRows));
    }
  }

  std::int64_t first_row() const { return first_row_; }
  static std::int64_t first_column(std::size_t tile) {
    return static_cast<std::int64_t>(tile) * Tile::kWidth;
  }
  std::size_t output_at(int row, std::size_t tile) const {
    return static_cast<std::size_t>((first_row_ + row - j_begin_) * impl_.width +
                                    first_column(tile));
  }

  /// The wanted rows of the current band, counted from its first row.
  int row_begin() const { return row_begin_; }
  int row_end() const { return row_end_; }
  /// The wanted pixels of a tile.
  TileRectangle wanted_of(std::size_t tile) const {
    const std::int64_t columns =
        std::min<std::int64_t>(Tile::kWidth, impl_.width - first_column(tile));
    return {0, static_cast<int>(columns), row_begin_, row_end_};
  }

  /// The part of a rectangle that lies in a tile's wanted rows.
  TileRectangle within_tile(const scene::PixelRectangle& pixels, std::size_t tile) const;
  TileRays rays_of(std::size_t tile) const;

 private:
  const Visibility::Impl& impl_;
  std::int64_t j_begin_, j_end_;
  std::int64_t first_row_ = 0;
  int row_begin_ = 0, row_end_ = 0;
};

DecidedBy nearest_of_rows(const Visibility::Impl& impl, std::int64_t j_begin, std::int64_t j_end,
                          const SeenRows& rows, Certified certified);
DecidedBy classes_of_rows(const Visibility::Impl& impl, std::size_t sphere, std::int64_t j_begin,
                          std::int64_t j_end, std::span<HitClass> classes);

}  // namespace raycheck::reference
