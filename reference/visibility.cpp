#include "reference/visibility.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/visibility_kernel.h"

namespace raycheck::reference {
namespace {

using scene::Bounds;
using scene::PixelRectangle;

static_assert(Visibility::kBandRows == Tile::kHeight);

double middle(const Bounds& x) { return x.low / 2 + x.high / 2; }
double half_width(const Bounds& x) { return std::max(x.high - middle(x), middle(x) - x.low); }
double magnitude(const Bounds& x) { return std::max(std::abs(x.low), std::abs(x.high)); }

/// What the bound of the filter takes from the image plane; the names are those of
/// visibility_kernel.h.
struct PlaneSizes {
  double N = 0, X = 0, Y = 0;
  double delta = 0;
  double A = 0, E_a = 0;
};

constexpr double kUnitRoundoff = 0x1p-53;
/// What computing bounds in doubles may lose.
constexpr double kSlack = 1.01;

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
  sizes.E_a = kSlack * (4 * kUnitRoundoff * sizes.A + I_a);
  return sizes;
}

FilteredSphere filtered(const scene::SpherePlan& plan, std::size_t index, const PlaneSizes& sizes) {
  FilteredSphere sphere;
  sphere.u = middle(plan.seen.u);
  sphere.v = middle(plan.seen.v);
  sphere.w = middle(plan.seen.w);
  sphere.power = middle(plan.seen.power);
  sphere.nearest_distance = plan.nearest_distance;
  sphere.index = static_cast<std::int32_t>(index);
  sphere.roots_matter = plan.origin_inside || plan.reaches_behind;
  const auto& [N, X, Y, delta, A, E_a] = sizes;
  const double rho =
      std::max({half_width(plan.seen.u), half_width(plan.seen.v), half_width(plan.seen.w)});
  const double u = std::abs(sphere.u), v = std::abs(sphere.v), w = std::abs(sphere.w);
  const double c = std::abs(sphere.power);
  const double I_b = (N + X + Y) * rho + delta * (u + v + w + 3 * rho);
  const double B = kSlack * (N * w + Y * v + X * u + I_b);
  const double E_b = kSlack * (4 * kUnitRoundoff * B + I_b);
  const double E =
      kSlack * (2.2 * B * E_b + 2.2 * kUnitRoundoff * B * B +
                c * (1.1 * E_a + 2.2 * kUnitRoundoff * A) + 1.1 * half_width(plan.seen.power) * A);
  sphere.decided = kDecidedBeyond * E;
  sphere.root_margin = kSlack * (E_b + 0.52 * std::sqrt(E / kDecidedBeyond) +
                                 4 * kUnitRoundoff * (B + std::sqrt(B * B + c * A)));
  sphere.exact = !(E >= kLeastBound && sphere.decided <= kLargestBound);
  return sphere;
}

/// Lists by band (or tile) in one array: those of k are items[begin[k]] to items[begin[k + 1]].
struct Lists {
  std::vector<std::uint32_t> items;
  std::vector<std::size_t> begin;

  std::span<const std::uint32_t> of(std::size_t k) const {
    return std::span(items).subspan(begin[k], begin[k + 1] - begin[k]);
  }
};

/// Sorts `count` items into lists, in order; item k goes to lists first to last of places(k).
template <class Places>
void distribute(std::size_t count, std::size_t lists, const Places& places, Lists& result) {
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
    for (std::size_t list = first; list < last; ++list) {
      result.items[next[list]++] = static_cast<std::uint32_t>(k);
    }
  }
}

std::pair<std::size_t, std::size_t> blocks(std::int64_t begin, std::int64_t end, int size) {
  return {static_cast<std::size_t>(begin / size), static_cast<std::size_t>((end - 1) / size + 1)};
}

}  // namespace

struct Visibility::Impl {
  Impl(const scene::Scene& its_scene, scene::ScenePlan its_plan);

  /// One call for some rows, which keeps what tiles share.
  class Rows;

  scene::Scene scene;
  scene::ScenePlan plan;
  ExactCamera camera;
  std::int64_t width, height;
  PlaneSizes sizes;
  std::vector<double> alpha, beta;  ///< alpha padded to whole tiles.
  double near;
  double start_factor;
  TileScale scale;
  /// By nearest distance; their rectangles; those of each band.
  std::vector<FilteredSphere> spheres;
  std::vector<PixelRectangle> rectangles;
  Lists bands;
};

Visibility::Impl::Impl(const scene::Scene& its_scene, scene::ScenePlan its_plan)
    : scene(its_scene),
      plan(std::move(its_plan)),
      camera(scene.camera.value(), plan.conventions),
      width(scene.camera->width),
      height(scene.camera->height),
      near(middle(plan.eye.near())) {
  std::vector<Bounds> columns, rows;
  for (std::int64_t i = 0; i < width; ++i) {
    columns.push_back(plan.eye.alpha(static_cast<double>(i)));
    alpha.push_back(middle(columns.back()));
  }
  for (std::int64_t j = 0; j < height; ++j) {
    rows.push_back(plan.eye.beta(static_cast<double>(j)));
    beta.push_back(middle(rows.back()));
  }
  alpha.resize(static_cast<std::size_t>((width - 1) / Tile::kWidth + 1) * Tile::kWidth,
               alpha.back());
  sizes = plane_sizes(columns, rows, plan.eye.near());

  const bool from_pixels = plan.conventions.origin == scene::Origin::kPixel;
  const auto& [plane, lengths] = plan.eye.scaling();
  start_factor = from_pixels ? std::ldexp(1.0, plane - lengths) : 0;
  const auto axis = [](const scene::EyeSpace::Axis& of) {
    return std::array<double, 3>{middle(of[0]), middle(of[1]), middle(of[2])};
  };
  const scene::Point3& eye = scene.camera->eye;
  scale = {std::ldexp(1.0, lengths), from_pixels ? std::ldexp(1.0, plane) : 0,
           {eye.x, eye.y, eye.z},    axis(plan.eye.U()),
           axis(plan.eye.V()),       axis(plan.eye.W())};

  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
    if (!plan.spheres[k].pixels.empty()) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return plan.spheres[a].nearest_distance < plan.spheres[b].nearest_distance;
  });
  const bool scales_fit = std::isnormal(scale.lengths) && std::isnormal(std::ldexp(1.0, plane)) &&
                          (!from_pixels || std::isnormal(start_factor));
  for (const std::size_t k : order) {
    spheres.push_back(filtered(plan.spheres[k], k, sizes));
    rectangles.push_back(plan.spheres[k].pixels);
    spheres.back().exact = spheres.back().exact || !scales_fit || !plan.items.filter;
  }
  distribute(
      spheres.size(), static_cast<std::size_t>((height - 1) / kBandRows + 1),
      [this](std::size_t k) {
        return blocks(rectangles[k].j_begin, rectangles[k].j_end, Tile::kHeight);
      },
      bands);
}

class Visibility::Impl::Rows {
 public:
  Rows(const Impl& impl, std::int64_t j_begin, std::int64_t j_end)
      : impl_(impl), j_begin_(j_begin), j_end_(j_end) {
    if (j_begin < 0 || j_begin > j_end || j_end > impl.height) {
      throw std::invalid_argument("rows " + std::to_string(j_begin) + " to " +
                                  std::to_string(j_end) + ": the image has " +
                                  std::to_string(impl.height));
    }
  }

  template <class T>
  void require_fit(std::span<T> array) const {
    const auto pixels = static_cast<std::size_t>((j_end_ - j_begin_) * impl_.width);
    if (!array.empty() && array.size() != pixels) {
      throw std::invalid_argument("an array of " + std::to_string(array.size()) + " for " +
                                  std::to_string(pixels) + " pixels");
    }
  }

  DecidedBy nearest(const SeenRows& rows, Certified certified) {
    require_fit(rows.sphere);
    for (const auto& array : {rows.parameter, rows.point_x, rows.point_y, rows.point_z}) {
      require_fit(array);
    }
    rows_ = rows;
    all_quantities_.resize(impl_.plan.items.quantities ? 0 : Tile::kPixels);
    DecidedBy decided_by;
    for_each_band([&](std::size_t band) {
      const std::span<const std::uint32_t> in_band = impl_.bands.of(band);
      if (in_band.empty()) {
        fill_band(band);
        return;
      }
      distribute(
          in_band.size(), static_cast<std::size_t>((impl_.width - 1) / Tile::kWidth + 1),
          [&](std::size_t k) {
            const PixelRectangle& pixels = impl_.rectangles[in_band[k]];
            return blocks(pixels.i_begin, pixels.i_end, Tile::kWidth);
          },
          tiles_);
      for (std::size_t tile = 0; tile + 1 < tiles_.begin.size(); ++tile) {
        list_spheres(band, tile, in_band);
        clear(tile_);
        const TileRays rays = rays_of(band, tile);
        sweep(list_, rays, certified, tile_);
        finish(band, tile, rays, certified, decided_by);
      }
    });
    decided_by.filter =
        static_cast<std::uint64_t>((j_end_ - j_begin_) * impl_.width) - decided_by.fallback();
    return decided_by;
  }

  DecidedBy classes(std::size_t sphere, std::span<HitClass> classes) {
    require_fit(classes);
    std::fill(classes.begin(), classes.end(), HitClass::kMiss);
    DecidedBy decided_by;
    const auto found = std::find_if(
        impl_.spheres.begin(), impl_.spheres.end(),
        [&](const FilteredSphere& s) { return static_cast<std::size_t>(s.index) == sphere; });
    if (sphere >= impl_.scene.spheres.size()) {
      throw std::invalid_argument("sphere " + std::to_string(sphere) + ": the scene has " +
                                  std::to_string(impl_.scene.spheres.size()));
    }
    if (found != impl_.spheres.end()) {
      const auto position = static_cast<std::size_t>(found - impl_.spheres.begin());
      for_each_band(
          [&](std::size_t band) { classes_of_band(band, position, classes, decided_by); });
    }
    decided_by.filter = classes.size() - decided_by.fallback();
    return decided_by;
  }

 private:
  template <class Body>
  void for_each_band(Body body) {
    for (std::int64_t j = j_begin_ / kBandRows * kBandRows; j < j_end_; j += kBandRows) {
      row_begin_ = static_cast<int>(std::max(j, j_begin_) - j);
      row_end_ = static_cast<int>(std::min(j + kBandRows, j_end_) - j);
      body(static_cast<std::size_t>(j / kBandRows));
    }
  }

  std::int64_t first_row(std::size_t band) const {
    return static_cast<std::int64_t>(band) * kBandRows;
  }
  static std::int64_t first_column(std::size_t tile) {
    return static_cast<std::int64_t>(tile) * Tile::kWidth;
  }
  int columns_of(std::size_t tile) const {
    return static_cast<int>(std::min<std::int64_t>(Tile::kWidth, impl_.width - first_column(tile)));
  }
  std::size_t output_at(std::size_t band, int row, std::size_t tile) const {
    return static_cast<std::size_t>((first_row(band) + row - j_begin_) * impl_.width +
                                    first_column(tile));
  }

  void fill_band(std::size_t band) {
    const std::size_t from = output_at(band, row_begin_, 0);
    const auto count = static_cast<std::size_t>((row_end_ - row_begin_) * impl_.width);
    const auto fill = [&](auto array, auto value) {
      if (!array.empty())
        std::fill_n(array.begin() + static_cast<std::ptrdiff_t>(from), count, value);
    };
    fill(rows_.sphere, kNoSphere);
    for (const auto& array : {rows_.parameter, rows_.point_x, rows_.point_y, rows_.point_z}) {
      fill(array, kNoParameter);
    }
  }

  TileRectangle within_tile(const PixelRectangle& pixels, std::size_t band,
                            std::size_t tile) const {
    const auto clamp = [](std::int64_t x, int low, int high) {
      return static_cast<int>(std::clamp<std::int64_t>(x, low, high));
    };
    const std::int64_t i = first_column(tile), j = first_row(band);
    return {clamp(pixels.i_begin - i, 0, Tile::kWidth), clamp(pixels.i_end - i, 0, Tile::kWidth),
            clamp(pixels.j_begin - j, row_begin_, row_end_),
            clamp(pixels.j_end - j, row_begin_, row_end_)};
  }

  void list_spheres(std::size_t band, std::size_t tile, std::span<const std::uint32_t> in_band) {
    list_.clear();
    again_.clear();
    const std::span<const std::uint32_t> in_tile = tiles_.of(tile);
    if (!impl_.plan.items.constants) again_.reserve(in_tile.size());
    for (const std::uint32_t entry : in_tile) {
      const std::uint32_t position = in_band[entry];
      const FilteredSphere* sphere = &impl_.spheres[position];
      if (!impl_.plan.items.constants) sphere = &again_.emplace_back(reckoned_again(*sphere));
      list_.push_back({sphere, within_tile(impl_.rectangles[position], band, tile)});
    }
  }

  /// The constants of a sphere, as if they were not kept.
  FilteredSphere reckoned_again(const FilteredSphere& kept) const {
    const auto index = static_cast<std::size_t>(kept.index);
    scene::SpherePlan plan = impl_.plan.spheres[index];
    plan.seen = impl_.plan.eye.sphere(impl_.scene.spheres[index]);
    FilteredSphere sphere = filtered(plan, index, impl_.sizes);
    sphere.exact = kept.exact;
    return sphere;
  }

  TileRays rays_of(std::size_t band, std::size_t tile) const {
    TileRays rays;
    rays.alpha = impl_.alpha.data() + first_column(tile);
    const auto least = [](double x, double y) { return x * y <= 0 ? 0 : std::min(x * x, y * y); };
    const std::int64_t j = first_row(band);
    const auto rows = std::min<std::int64_t>(Tile::kHeight, impl_.height - j);
    for (std::int64_t row = 0; row < rows; ++row) {
      rays.beta[static_cast<std::size_t>(row)] = impl_.beta[static_cast<std::size_t>(j + row)];
    }
    rays.near = impl_.near;
    rays.start_factor = impl_.start_factor;
    rays.start_margin = 2 * impl_.start_factor * impl_.sizes.E_a;
    const double least_sq = impl_.near * impl_.near +
                            least(rays.alpha[0], rays.alpha[Tile::kWidth - 1]) +
                            least(rays.beta[0], rays.beta[static_cast<std::size_t>(rows - 1)]);
    rays.least_length = std::sqrt(std::max(0.0, least_sq - impl_.sizes.E_a));
    rays.larger_counts = impl_.plan.conventions.root == scene::Root::kNearest;
    return rays;
  }

  /// Writes the tile; what the filter left goes to the exact ray.
  void finish(std::size_t band, std::size_t tile, const TileRays& rays, Certified certified,
              DecidedBy& decided_by) {
    const int columns = columns_of(tile);
    const std::size_t at = output_at(band, row_begin_, tile);
    const auto from = [at](auto array) { return array.empty() ? nullptr : array.data() + at; };
    TileOutput output{from(rows_.sphere),
                      from(rows_.parameter),
                      {from(rows_.point_x), from(rows_.point_y), from(rows_.point_z)},
                      static_cast<std::ptrdiff_t>(impl_.width)};
    const double least =
        finish_tile(tile_, row_begin_, row_end_, columns, rays, impl_.scale, output);
    if (!impl_.plan.items.quantities) reckon_all(rays, columns);
    if (certified == Certified::kNo) return;
    if (!rows_.parameter.empty() || !rows_.point_x.empty()) require_precise(least, columns);
    const std::uint64_t inside =
        columns == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << columns) - 1;
    for (int row = row_begin_; row < row_end_; ++row) {
      for (std::uint64_t left = tile_.undecided[static_cast<std::size_t>(row)] & inside; left != 0;
           left &= left - 1) {
        const int column = __builtin_ctzll(left);
        const Rung rung =
            decide_exactly({first_column(tile) + column, first_row(band) + row},
                           output_at(band, row, tile) + static_cast<std::size_t>(column));
        ++decided_by.rungs[static_cast<std::size_t>(rung)];
      }
    }
  }

  /// s and Q of the tile though nobody asked.
  void reckon_all(const TileRays& rays, int columns) {
    double* const scratch = all_quantities_.data();
    finish_tile(tile_, row_begin_, row_end_, columns, rays, impl_.scale,
                {nullptr, scratch, {scratch, scratch, scratch}, Tile::kWidth});
  }

  /// Leaves to the exact ray the pixels whose root margin is above kVisibleParameterError m.
  void require_precise(double least, int columns) {
    double margin = 0;
    for (const SphereInTile& entry : list_) {
      if (!entry.sphere->exact) margin = std::max(margin, entry.sphere->root_margin);
    }
    constexpr double kShare = kVisibleParameterError / 2;  // the rest is for roundings
    if (margin <= kShare * least) return;
    for (const SphereInTile& entry : list_) {
      if (entry.sphere->exact || entry.sphere->root_margin <= kShare * least) continue;
      for (int row = entry.pixels.j_begin; row < entry.pixels.j_end; ++row) {
        for (int column = entry.pixels.i_begin; column < std::min(entry.pixels.i_end, columns);
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

  Rung decide_exactly(const scene::Pixel& pixel, std::size_t at) {
    candidates_.clear();
    for (const SphereInTile& entry : list_) {
      const auto index = static_cast<std::size_t>(entry.sphere->index);
      if (impl_.plan.spheres[index].pixels.contains(pixel)) candidates_.push_back(index);
    }
    std::sort(candidates_.begin(), candidates_.end());  // the first in the file among equals
    spheres_.clear();
    for (const std::size_t index : candidates_) spheres_.push_back(impl_.scene.spheres[index]);
    const ExactRay ray(impl_.camera, pixel);
    Rung highest = Rung::kIntervals;
    const auto seen = ray.nearest(spheres_, impl_.plan.conventions, &highest);
    const auto put = [at](auto array, auto value) {
      if (!array.empty()) array[at] = value;
    };
    put(rows_.sphere, seen ? static_cast<std::int32_t>(candidates_[seen->index]) : kNoSphere);
    if (!rows_.parameter.empty()) {
      rows_.parameter[at] =
          seen ? ray.rounded_parameter(spheres_[seen->index], seen->intersection) : kNoParameter;
    }
    if (rows_.point_x.empty() && rows_.point_y.empty() && rows_.point_z.empty()) return highest;
    const scene::Point3 point = seen ? ray.rounded_point(spheres_[seen->index], seen->intersection)
                                     : scene::Point3{kNoParameter, kNoParameter, kNoParameter};
    put(rows_.point_x, point.x);
    put(rows_.point_y, point.y);
    put(rows_.point_z, point.z);
    return highest;
  }

  void classes_of_band(std::size_t band, std::size_t position, std::span<HitClass> classes,
                       DecidedBy& decided_by) {
    const PixelRectangle& pixels = impl_.rectangles[position];
    const std::int64_t j = first_row(band);
    if (pixels.j_end <= j || pixels.j_begin >= j + kBandRows) return;
    const auto [first, last] = blocks(pixels.i_begin, pixels.i_end, Tile::kWidth);
    const FilteredSphere& sphere = impl_.spheres[position];
    for (std::size_t tile = first; tile < last; ++tile) {
      clear(tile_);
      const SphereInTile entry{&sphere, within_tile(pixels, band, tile)};
      const TileRays rays = rays_of(band, tile);
      sweep_class(entry, rays, tile_);
      for (int row = entry.pixels.j_begin; row < entry.pixels.j_end; ++row) {
        HitClass* const to = classes.data() + output_at(band, row, tile);
        const std::uint64_t undecided = tile_.undecided[static_cast<std::size_t>(row)];
        for (int column = entry.pixels.i_begin; column < entry.pixels.i_end; ++column) {
          const bool hit = tile_.sphere[static_cast<std::size_t>(row * Tile::kWidth + column)] >= 0;
          to[column] = hit ? HitClass::kHit : HitClass::kMiss;
          if ((undecided >> column & 1) == 0) continue;
          const ExactRay ray(impl_.camera, {first_column(tile) + column, j + row});
          Rung highest = Rung::kIntervals;
          to[column] = ray.intersect(impl_.scene.spheres[static_cast<std::size_t>(sphere.index)],
                                     impl_.plan.conventions.root, Engine::kFiltered, &highest)
                           .hit_class;
          ++decided_by.rungs[static_cast<std::size_t>(highest)];
        }
      }
    }
  }

  const Impl& impl_;
  std::int64_t j_begin_, j_end_;
  int row_begin_ = 0, row_end_ = 0;  ///< Of the band at hand.
  SeenRows rows_;
  Tile tile_;
  Lists tiles_;
  std::vector<SphereInTile> list_;
  std::vector<FilteredSphere> again_;
  std::vector<double> all_quantities_;
  std::vector<std::size_t> candidates_;
  std::vector<scene::Sphere> spheres_;
};

Visibility::Visibility(const scene::Scene& scene, scene::ScenePlan plan)
    : impl_(std::make_unique<const Impl>(scene, std::move(plan))) {}
Visibility::~Visibility() = default;
Visibility::Visibility(Visibility&&) noexcept = default;

const scene::Scene& Visibility::scene() const { return impl_->scene; }
const scene::ScenePlan& Visibility::plan() const { return impl_->plan; }

DecidedBy Visibility::nearest(std::int64_t j_begin, std::int64_t j_end,
                              const SeenRows& rows) const {
  return Impl::Rows(*impl_, j_begin, j_end).nearest(rows, Certified::kYes);
}

void Visibility::nearest_uncertified(std::int64_t j_begin, std::int64_t j_end,
                                     const SeenRows& rows) const {
  Impl::Rows(*impl_, j_begin, j_end).nearest(rows, Certified::kNo);
}

DecidedBy Visibility::classes(std::size_t sphere, std::int64_t j_begin, std::int64_t j_end,
                              std::span<HitClass> classes) const {
  return Impl::Rows(*impl_, j_begin, j_end).classes(sphere, classes);
}

DecidedBy& DecidedBy::operator+=(const DecidedBy& other) {
  filter += other.filter;
  for (std::size_t k = 0; k < rungs.size(); ++k) rungs[k] += other.rungs[k];
  return *this;
}

DecidedBy nearest_in_parallel(const Visibility& visibility, std::int64_t j_begin,
                              std::int64_t j_end, const SeenRows& rows, int threads) {
  constexpr std::int64_t kRows = Visibility::kBandRows;
  const auto width = static_cast<std::size_t>(visibility.scene().camera->width);
  const std::int64_t first_band = j_begin / kRows;
  const std::int64_t bands = j_end > j_begin ? (j_end - 1) / kRows - first_band + 1 : 0;
  std::vector<DecidedBy> decided_by(static_cast<std::size_t>(bands));
  const auto band_rows = [&](std::int64_t band) {
    const std::int64_t begin = std::max(j_begin, (first_band + band) * kRows);
    const std::int64_t end = std::min(j_end, (first_band + band + 1) * kRows);
    const auto part = [&](auto array) {
      return array.empty() ? array
                           : array.subspan(static_cast<std::size_t>(begin - j_begin) * width,
                                           static_cast<std::size_t>(end - begin) * width);
    };
    decided_by[static_cast<std::size_t>(band)] =
        visibility.nearest(begin, end,
                           {part(rows.sphere), part(rows.parameter), part(rows.point_x),
                            part(rows.point_y), part(rows.point_z)});
  };
  // More threads than cores would only make oneTBB warn.
  tbb::task_arena arena(std::min(threads, tbb::this_task_arena::max_concurrency()));
  arena.execute([&] { tbb::parallel_for(std::int64_t{0}, bands, band_rows); });
  return std::accumulate(decided_by.begin(), decided_by.end(), DecidedBy{},
                         [](DecidedBy sum, const DecidedBy& band) { return sum += band; });
}

}  // namespace raycheck::reference
