#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "reference/visibility/visibility_impl.h"
#include "scene/interruption.h"

namespace raycheck::reference {
namespace {

using scene::PixelRectangle;

void classes_of_band(const Visibility::Impl& impl, const RowsInTiles& rows, std::size_t index,
                     std::span<HitClass> classes, DecidedBy& decided_by) {
  const PixelRectangle& pixels = impl.plan.spheres[index].pixels;
  const std::int64_t j = rows.first_row();
  if (pixels.j_end <= j || pixels.j_begin >= j + Visibility::kBandRows) return;
  const auto [first, last] = blocks(pixels.i_begin, pixels.i_end, Tile::kWidth);
  const FilteredSphere sphere = impl.filtered_of(impl.plan.spheres[index], index);
  Tile in_tile;
  for (std::size_t tile = first; tile < last; ++tile) {
    scene::poll();
    clear(in_tile, {0, Tile::kWidth, 0, Tile::kHeight});
    const SphereInTile entry{&sphere, rows.within_tile(pixels, tile)};
    const TileRays rays = rows.rays_of(tile);
    sweep_class(entry, rays, in_tile);
    for (int row = entry.pixels.j_begin; row < entry.pixels.j_end; ++row) {
      HitClass* const to = classes.data() + rows.output_at(row, tile);
      const std::uint64_t undecided = in_tile.undecided[static_cast<std::size_t>(row)];
      for (int column = entry.pixels.i_begin; column < entry.pixels.i_end; ++column) {
        const bool hit = in_tile.sphere[static_cast<std::size_t>(row * Tile::kWidth + column)] >= 0;
        to[column] = hit ? HitClass::kHit : HitClass::kMiss;
        if ((undecided >> column & 1) == 0) continue;
        const ExactRay ray(impl.camera, {rows.first_column(tile) + column, j + row});
        FilterStage highest = FilterStage::kIntervals;
        to[column] =
            ray.intersect(impl.scene.spheres[index], impl.plan.conventions, {.highest = &highest})
                .hit_class;
        ++decided_by.stages[static_cast<std::size_t>(highest)];
      }
    }
  }
}

}  // namespace

DecidedBy classes_of_rows(const Visibility::Impl& impl, std::size_t sphere, std::int64_t j_begin,
                          std::int64_t j_end, std::span<HitClass> classes) {
  if (sphere >= impl.plan.spheres.size()) {
    throw std::invalid_argument("sphere " + std::to_string(sphere) + ": the scene has " +
                                std::to_string(impl.plan.spheres.size()));
  }
  RowsInTiles rows(impl, j_begin, j_end);
  rows.require_fit(classes.size());
  std::fill(classes.begin(), classes.end(), HitClass::kMiss);
  DecidedBy decided_by;
  if (!impl.plan.spheres[sphere].pixels.empty()) {
    rows.for_each_band(
        [&](std::size_t /*band*/) { classes_of_band(impl, rows, sphere, classes, decided_by); });
  }
  decided_by.filter = classes.size() - decided_by.fallback();
  return decided_by;
}

}  // namespace raycheck::reference
