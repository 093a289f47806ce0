#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <stdexcept>
#include <vector>

#include "reference/visibility/visibility_impl.h"
#include "scene/interruption.h"

namespace raycheck::reference {
namespace {

using scene::PixelRectangle;

/// One call for some rows. The data that tiles share are computed once.
class NearestOfRows {
 public:
  NearestOfRows(const Visibility::Impl& impl, std::int64_t j_begin, std::int64_t j_end)
      : impl_(impl), at_(impl, j_begin, j_end) {}

  DecidedBy answer(const SeenRows& rows, Certified certified) {
    at_.require_fit(rows.sphere.size());
    at_.require_fit(rows.ties.size());
    for (const auto& array : {rows.parameter, rows.point_x, rows.point_y, rows.point_z}) {
      at_.require_fit(array.size());
    }
    if (rows.point_x.empty() != rows.point_y.empty() ||
        rows.point_x.empty() != rows.point_z.empty()) {
      throw std::invalid_argument("points: give an array for each coordinate, or for none");
    }
    rows_ = rows;
    all_quantities_.resize(impl_.plan.items.quantities ? 0 : Tile::kPixels);
    DecidedBy decided_by;
    at_.for_each_band([&](std::size_t band) {
      band_ = band;
      reach_ = 0;
      left_ = impl_.bands(reach_).of(band);
      parts_ = listed_ = 0;
      tangents_ = {};
      if (!has_more()) {
        fill_band();
        return;
      }
      for (std::size_t tile = 0; tile < impl_.tile_count(); ++tile) {
        scene::poll();
        clear(tile_, at_.wanted_of(tile));
        const TileRays rays = at_.rays_of(tile);
        sweep_spheres(tile, rays, certified);
        finish(tile, rays, certified, decided_by);
      }
    });
    decided_by.filter = at_.pixels() - decided_by.fallback();
    return decided_by;
  }

 private:
  void fill_band() {
    const std::size_t from = at_.output_at(at_.row_begin(), 0);
    const auto count = static_cast<std::size_t>((at_.row_end() - at_.row_begin()) * impl_.width);
    const auto fill = [&](auto array, auto value) {
      if (!array.empty())
        std::fill_n(array.begin() + static_cast<std::ptrdiff_t>(from), count, value);
    };
    fill(rows_.sphere, kNoSphere);
    fill(rows_.ties, 0);
    for (const auto& array : {rows_.parameter, rows_.point_x, rows_.point_y, rows_.point_z}) {
      fill(array, kNoParameter);
    }
  }

  /// Lists more of the band's spheres by their tiles: as many as before, and a few for each tile.
  /// Of many spheres, most are hidden in all tiles.
  void list_more() {
    if (left_.empty()) left_ = impl_.bands(++reach_).of(band_);
    const auto next = left_.first(
        std::min(left_.size(), listed_ + kListedForEach * impl_.tile_count() + kListedAtLeast));
    left_ = left_.subspan(next.size());
    listed_ += next.size();
    columns_.clear();
    for (const std::uint32_t index : next) {
      const PixelRectangle& pixels = impl_.plan.spheres[index].pixels;
      columns_.push_back(blocks(pixels.i_begin, pixels.i_end, Tile::kWidth));
    }
    if (tiles_.size() == parts_) tiles_.emplace_back();
    distribute(
        next.size(), impl_.tile_count(), [&](std::size_t k) { return columns_[k]; },
        [&](std::size_t k) { return next[k]; }, tiles_[parts_++]);
  }
  bool has_more() const { return !left_.empty() || std::isfinite(impl_.reach_end[reach_]); }
  /// A lower bound on the distance of the spheres that are not listed yet.
  double nearest_left() const {
    return left_.empty() ? impl_.reach_end[reach_] : no_farther_than(left_.front());
  }
  static constexpr std::size_t kListedForEach = 16, kListedAtLeast = 64;

  /// After this number of swept pixels, tests whether the remaining spheres are hidden.
  static constexpr int kLookAfter = Tile::kPixels;

  /// Sweeps spheres over the tile, and lists them. The others are hidden in every pixel.
  void sweep_spheres(std::size_t tile, const TileRays& rays, Certified certified) {
    list_.clear();
    computed_.clear();
    double margin = 0;
    for (std::size_t part = 0; part < parts_ || has_more(); ++part) {
      if (part == parts_) {
        if (part > 0 && all_nearer(nearest_left(), margin, rays)) return;
        list_more();
      }
      const std::span<const std::uint32_t> in_tile = tiles_[part].of(tile);
      for (std::size_t k = 0; k < in_tile.size();) {
        const std::size_t swept = list_.size();
        if (swept > 0 && all_nearer(no_farther_than(in_tile[k]), margin, rays)) return;
        for (int pixels = 0; k < in_tile.size() && pixels < kLookAfter; ++k) {
          const std::uint32_t index = in_tile[k];
          const TileRectangle within = at_.within_tile(impl_.plan.spheres[index].pixels, tile);
          if (within.count() == 0) continue;  // It is in other rows of the band.
          list_.push_back({&filtered(index), within, impl_.plan.nearest_distance[index]});
          pixels += within.count();
        }
        sweep(std::span(list_).subspan(swept), rays, certified, tile_, margin);
      }
    }
  }

  double no_farther_than(std::size_t index) const {
    return static_cast<double>(no_farther(impl_.plan.nearest_distance[index]));
  }
  bool all_nearer(double distance, double margin, const TileRays& rays) {
    return set_farthest(tile_) < hidden_below(distance, margin, rays.least_length);
  }

  const FilteredSphere& filtered(std::size_t index) {
    if (!impl_.kept.empty()) return impl_.kept[index];
    const scene::SpherePlan& planned = impl_.plan.spheres[index];
    if (impl_.plan.items.constants) {
      return computed_.emplace_back(impl_.filtered_of(planned, index));
    }
    scene::SpherePlan again = planned;
    again.seen = impl_.plan.eye.sphere(impl_.scene.spheres[index]);
    return computed_.emplace_back(impl_.filtered_of(again, index));
  }

  /// Writes the tile. The exact ray decides pixels that the filter left undecided.
  void finish(std::size_t tile, const TileRays& rays, Certified certified, DecidedBy& decided_by) {
    const TileRectangle wanted = at_.wanted_of(tile);
    const std::size_t at = at_.output_at(at_.row_begin(), tile);
    const auto from = [at](auto array) { return array.empty() ? nullptr : array.data() + at; };
    TileOutput output{from(rows_.sphere),
                      from(rows_.parameter),
                      {from(rows_.point_x), from(rows_.point_y), from(rows_.point_z)},
                      static_cast<std::ptrdiff_t>(impl_.width)};
    const double least = finish_tile(tile_, wanted, rays, impl_.scale, output);
    if (!impl_.plan.items.quantities) compute_all(rays, wanted);
    if (certified == Certified::kNo) return;
    const bool is_precise = !wants_values() || is_plane_precise(rays);
    if (wants_values()) require_precise(is_precise, least, wanted);
    std::uint64_t undecided = 0;
    const std::uint64_t inside = columns_of(wanted);
    for (int row = 0; row < Tile::kHeight; ++row) {
      std::uint64_t& in_row = tile_.undecided[static_cast<std::size_t>(row)];
      in_row = row < wanted.j_begin || row >= wanted.j_end ? 0 : in_row & inside;
      undecided |= in_row;
    }
    if (undecided != 0 && is_precise && decide_in_pairs(tile, rays, decided_by)) {
      finish_tile(tile_, wanted, rays, impl_.scale, output);
    }
    if (!rows_.ties.empty()) count_one(tile, wanted);
    if (undecided == 0) return;
    for (int row = wanted.j_begin; row < wanted.j_end; ++row) {
      for (std::uint64_t left = tile_.undecided[static_cast<std::size_t>(row)]; left != 0;
           left &= left - 1) {
        const int column = __builtin_ctzll(left);
        const FilterStage stage =
            decide_exactly({at_.first_column(tile) + column, at_.first_row() + row},
                           at_.output_at(row, tile) + static_cast<std::size_t>(column),
                           tangents_[static_cast<std::size_t>(row)]);
        ++decided_by.stages[static_cast<std::size_t>(stage)];
      }
    }
  }

  /// Writes that each pixel's sphere has no ties: the exact ray decides pixels that have some.
  void count_one(std::size_t tile, const TileRectangle& wanted) {
    for (int row = wanted.j_begin; row < wanted.j_end; ++row) {
      std::int32_t* const to = rows_.ties.data() + at_.output_at(row, tile);
      const auto from = static_cast<std::size_t>(row * Tile::kWidth);
      for (int column = 0; column < wanted.i_end; ++column) {
        to[column] = tile_.sphere[from + static_cast<std::size_t>(column)] >= 0 ? 1 : 0;
      }
    }
  }

  /// Computes s and Q of the tile, even if they are not wanted.
  void compute_all(const TileRays& rays, const TileRectangle& wanted) {
    double* const scratch = all_quantities_.data();
    finish_tile(tile_, wanted, rays, impl_.scale,
                {nullptr, scratch, {scratch, scratch, scratch}, Tile::kWidth});
  }

  // Why s and Q are within kVisibleParameterError = 2 kShare. The filter's s and Q are kept if
  //   |m^ - m| <= E_m <= kShare m^, |g^ - g| <= 2 delta <= kShare/8 l, and, for Q, the axes are
  //   known to within kShare/32.
  // Then t^ = m^/l^ is off by less than (1 + 1/8) kShare t and a few roundings. l 2^plane, which is
  // at most t for a hit in front, is off by kShare/8 of itself. Together s is off by less than 1.3
  // kShare t. In Q - E = t (g/l), g/l is off by kShare/4 and, as a sum of three coordinates times
  // axes, by 6/32 kShare. Together a coordinate is off by less than 1.6 kShare t; its sum with E is
  // rounded.
  static constexpr double kShare = kVisibleParameterError / 2;

  bool wants_values() const { return !rows_.parameter.empty() || !rows_.point_x.empty(); }

  bool is_plane_precise(const TileRays& rays) const {
    return 2 * impl_.sizes.delta <= kShare / 8 * rays.least_length &&
           (rows_.point_x.empty() || impl_.axis_doubt <= kShare / 32);
  }

  /// Marks pixels as undecided whose s or Q is not precise.
  void require_precise(bool is_plane_precise, double least, const TileRectangle& wanted) {
    if (!is_plane_precise) {
      for (int row = wanted.j_begin; row < wanted.j_end; ++row) {
        for (int column = 0; column < wanted.i_end; ++column) {
          if (tile_.sphere[static_cast<std::size_t>(row * Tile::kWidth + column)] < 0) continue;
          tile_.undecided[static_cast<std::size_t>(row)] |= std::uint64_t{1} << column;
        }
      }
      return;
    }
    double margin = 0;
    for (const SphereInTile& entry : list_) {
      if (!entry.sphere->exact) margin = std::max(margin, entry.sphere->root_margin);
    }
    if (margin <= kShare * least) return;
    for (const SphereInTile& entry : list_) {
      if (entry.sphere->exact || entry.sphere->root_margin <= kShare * least) continue;
      for (int row = entry.pixels.j_begin; row < entry.pixels.j_end; ++row) {
        for (int column = entry.pixels.i_begin; column < std::min(entry.pixels.i_end, wanted.i_end);
             ++column) {
          const auto at = static_cast<std::size_t>(row * Tile::kWidth + column);
          if (tile_.sphere[at] == entry.sphere->index &&
              !(entry.sphere->root_margin <= kShare * tile_.numerator[at])) {
            tile_.undecided[static_cast<std::size_t>(row)] |= std::uint64_t{1} << column;
          }
        }
      }
    }
  }

  /// Sweeps spheres in double-doubles over the undecided pixels. Returns whether this decided one.
  bool decide_in_pairs(std::size_t tile, const TileRays& rays, DecidedBy& decided_by) {
    const PairView* const view = impl_.pair_view();
    if (view == nullptr) return false;
    pair_spheres_.clear();
    pair_spheres_.reserve(list_.size());
    pair_list_.clear();
    double margin = 0;
    for (const auto& [sphere, pixels, distance] : list_) {
      if (!any_undecided(pixels)) continue;
      const auto index = static_cast<std::size_t>(sphere->index);
      const FilteredSphereOf<Pair>& in_pairs =
          pair_spheres_.emplace_back(view->sphere(impl_.scene.spheres[index], index));
      pair_list_.push_back({&in_pairs, pixels, distance});
      if (!in_pairs.exact) margin = std::max(margin, in_pairs.root_margin);
    }
    clear(pair_tile_, tile_.undecided);
    sweep(pair_list_, view->rays(rays, at_.first_column(tile), at_.first_row()), pair_tile_);
    std::uint64_t decided = 0;
    for (std::size_t row = 0; row < Tile::kHeight; ++row) {
      const std::uint64_t candidates = tile_.undecided[row] & ~pair_tile_.undecided[row];
      for (std::uint64_t left = candidates; left != 0; left &= left - 1) {
        const std::size_t at =
            row * Tile::kWidth + static_cast<std::size_t>(std::countr_zero(left));
        const bool is_hit = pair_tile_.sphere[at] >= 0;
        if (is_hit && wants_values() && !(margin <= kShare * pair_tile_.numerator[at])) continue;
        tile_.numerator[at] = kNoParameter;
        if (is_hit) tile_.numerator[at] = pair_tile_.numerator[at];
        tile_.sphere[at] = pair_tile_.sphere[at];
        tile_.undecided[row] &= ~(left & -left);
        ++decided;
      }
    }
    decided_by.stages[static_cast<std::size_t>(FilterStage::kDoubleDoubles)] += decided;
    return decided > 0;
  }

  bool any_undecided(const TileRectangle& pixels) const {
    const std::uint64_t columns = columns_of(pixels);
    for (int row = pixels.j_begin; row < pixels.j_end; ++row) {
      if ((tile_.undecided[static_cast<std::size_t>(row)] & columns) != 0) return true;
    }
    return false;
  }

  /// The number of pixels of a row whose rays are tangent to the only sphere that they may meet.
  /// The discriminant is quadratic in alpha; if it is 0 at three columns, it is 0 at all. Then
  /// (f.d)^2 = c for every unit direction d in the plane of the row. f.d changes its sign from d to
  /// -d, so that it is 0 for some d, and therefore c = 0: the eye is on the sphere, and the lines
  /// of all rays touch the sphere there. This point is at s = 0 for focal rays, and behind the
  /// origin of all other rays.
  struct RowTangent {
    std::size_t sphere = 0;
    int columns = 0;
    FilterStage stage = FilterStage::kIntervals;

    bool is_whole_row(std::span<const std::size_t> candidates) const {
      return columns >= 3 && candidates.size() == 1 && candidates.front() == sphere;
    }
    void add(std::size_t of, const Intersection& at, FilterStage by) {
      if (at.hit_class != HitClass::kTangent) return;
      const bool is_same = of == sphere && columns > 0;
      columns = is_same ? columns + 1 : 1;
      stage = is_same ? std::max(stage, by) : by;
      sphere = of;
    }
  };

  FilterStage decide_exactly(const scene::Pixel& pixel, std::size_t at, RowTangent& tangent) {
    candidates_.clear();
    for (const SphereInTile& entry : list_) {
      const auto index = static_cast<std::size_t>(entry.sphere->index);
      if (impl_.plan.spheres[index].pixels.contains(pixel)) candidates_.push_back(index);
    }
    const auto put = [at](auto array, auto value) {
      if (!array.empty()) array[at] = value;
    };
    const auto put_all = [&](std::int32_t sphere, double s, const scene::Point3& Q,
                             std::size_t ties = 1) {
      put(rows_.sphere, sphere);
      put(rows_.ties, sphere == kNoSphere ? 0 : static_cast<std::int32_t>(ties));
      put(rows_.parameter, s);
      put(rows_.point_x, Q.x);
      put(rows_.point_y, Q.y);
      put(rows_.point_z, Q.z);
    };
    const scene::Point3 nowhere = {kNoParameter, kNoParameter, kNoParameter};
    const scene::Conventions& conventions = impl_.plan.conventions;
    if (tangent.is_whole_row(candidates_)) {
      if (counts_as_hit(HitClass::kTangent, conventions.tangent)) {
        const auto& [x, y, z] = impl_.scene.camera->eye;
        put_all(static_cast<std::int32_t>(tangent.sphere), 0, {x + 0.0, y + 0.0, z + 0.0});
      } else {
        put_all(kNoSphere, kNoParameter, nowhere);
      }
      return tangent.stage;
    }
    std::sort(candidates_.begin(), candidates_.end());  // the first in the file wins a tie
    spheres_.clear();
    for (const std::size_t index : candidates_) spheres_.push_back(impl_.scene.spheres[index]);
    const ExactRay ray(impl_.camera, pixel);
    FilterStage highest = FilterStage::kIntervals;
    const auto seen = ray.nearest(spheres_, conventions, {.highest = &highest});
    if (candidates_.size() == 1 && conventions.valid.is_usual() &&
        (seen || !counts_as_hit(HitClass::kTangent, conventions.tangent))) {
      tangent.add(candidates_.front(),
                  seen ? seen->intersection : ray.intersect(spheres_.front(), conventions),
                  highest);
    }
    if (!seen) {
      put_all(kNoSphere, kNoParameter, nowhere);
      return highest;
    }
    const scene::Sphere& sphere = spheres_[seen->index];
    put_all(static_cast<std::int32_t>(candidates_[seen->index]),
            rows_.parameter.empty() ? 0 : ray.rounded_parameter(sphere, seen->intersection),
            rows_.point_x.empty() ? nowhere : ray.rounded_point(sphere, seen->intersection),
            seen->ties.size());
    return highest;
  }

  const Visibility::Impl& impl_;
  RowsInTiles at_;
  SeenRows rows_;
  Tile tile_;
  std::size_t band_ = 0, reach_ = 0;
  // The band's spheres of the reach: left_ are not listed yet; the other `listed_` spheres are in
  // the first `parts_` of tiles_, by tile.
  std::span<const std::uint32_t> left_;
  std::vector<Lists> tiles_;
  std::size_t parts_ = 0, listed_ = 0;
  std::vector<Blocks> columns_;
  std::vector<SphereInTile> list_;
  std::deque<FilteredSphere> computed_;  ///< The spheres in list_ that are not in `kept`.
  PairTile pair_tile_;
  std::vector<FilteredSphereOf<Pair>> pair_spheres_;
  std::vector<SphereInTileOf<Pair>> pair_list_;
  std::array<RowTangent, Tile::kHeight> tangents_;
  std::vector<double> all_quantities_;
  std::vector<std::size_t> candidates_;
  std::vector<scene::Sphere> spheres_;
};

}  // namespace

DecidedBy nearest_of_rows(const Visibility::Impl& impl, std::int64_t j_begin, std::int64_t j_end,
                          const SeenRows& rows, Certified certified) {
  return NearestOfRows(impl, j_begin, j_end).answer(rows, certified);
}

}  // namespace raycheck::reference
