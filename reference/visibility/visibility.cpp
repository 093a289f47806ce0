#include "reference/visibility/visibility.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/visibility/visibility_impl.h"
#include "scene/interruption.h"

namespace raycheck::reference {

using scene::Bounds;

static_assert(Visibility::kBandRows == Tile::kHeight);

namespace {

/// Lengths below 2^kLargestExponent, and their sums and differences, are in the range of doubles.
constexpr int kLargestExponent = 1000;

/// Whether a length that was divided by 2^exponent is below 2^kLargestExponent.
bool fits(double length, int exponent) {
  return length == 0 || (std::isfinite(length) && std::ilogb(length) + exponent < kLargestExponent);
}

/// A sphere, its distance and the bands that it reaches. The distance is kept as the bits of a
/// float, which are in the same order as floats >= 0.
struct NearFirst {
  std::uint32_t distance, sphere;
  Blocks bands;
};

/// Sorts by distance; equal distances keep their order.
void sort(std::vector<NearFirst>& items) {
  constexpr int kDigit = (32 - kDistanceRounds) / 2;
  std::vector<NearFirst> sorted(items.size());
  for (const int shift : {kDistanceRounds, kDistanceRounds + kDigit}) {
    const auto digit = [shift](const NearFirst& item) {
      return item.distance >> shift & ((1U << kDigit) - 1);
    };
    std::array<std::size_t, (1U << kDigit) + 1> begin{};
    for (const NearFirst& item : items) ++begin[digit(item) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (const NearFirst& item : items) sorted[begin[digit(item)]++] = item;
    items.swap(sorted);
  }
}

}  // namespace

float no_farther(double distance) {
  const auto most = static_cast<double>(std::numeric_limits<float>::max());
  const auto rounded = static_cast<float>(std::min(distance, most));
  const float below =
      static_cast<double>(rounded) > distance ? std::nextafter(rounded, 0.0F) : rounded;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(below) >> kDistanceRounds
                                                                         << kDistanceRounds);
}

Visibility::Impl::Impl(scene::Scene its_scene, scene::ScenePlan its_plan)
    : scene(std::move(its_scene)),
      plan(std::move(its_plan)),
      camera(scene.camera.value(), plan.conventions),
      width(scene.camera->width),
      height(scene.camera->height),
      near(middle(plan.eye.near())) {
  for (const auto& [field, side] : {std::pair("camera.width", width), {"camera.height", height}}) {
    if (side <= kMostVisibleSide) continue;
    throw std::invalid_argument(std::string(field) + " = " + std::to_string(side) +
                                ": visibility is computed for at most " +
                                std::to_string(kMostVisibleSide) + " pixels");
  }
  set_plane();
  require_few_parts();
  set_reaches();
  bands(0);
  if (!plan.items.constants || plan.spheres.size() > kMostKept) return;
  kept.resize(plan.spheres.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (!plan.spheres[k].pixels.empty()) kept[k] = filtered_of(plan.spheres[k], k);
  }
}

void Visibility::Impl::set_plane() {
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
  const auto axis = [this](const scene::EyeSpace::Axis& of) {
    for (const Bounds& x : of) axis_doubt = std::max(axis_doubt, half_width(x));
    return std::array<double, 3>{middle(of[0]), middle(of[1]), middle(of[2])};
  };
  const scene::Point3& eye = scene.camera->eye;
  scale = {std::ldexp(1.0, lengths), from_pixels ? std::ldexp(1.0, plane) : 0,
           {eye.x, eye.y, eye.z},    axis(plan.eye.U()),
           axis(plan.eye.V()),       axis(plan.eye.W())};
  scales_fit = std::isfinite(scale.lengths) && std::isfinite(std::ldexp(1.0, plane)) &&
               (!from_pixels || std::isnormal(start_factor)) && fits(std::sqrt(sizes.A), plane) &&
               fits(std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)}), 0);
}

FilteredSphere Visibility::Impl::filtered_of(const scene::SpherePlan& planned,
                                             std::size_t index) const {
  FilteredSphere sphere = filtered(planned, index, sizes);
  const scene::EyeSphere& seen = planned.seen;
  const bool answers_fit =
      fits(std::sqrt(seen.distance_sq.high) + seen.radius.high, plan.eye.scaling().lengths);
  sphere.exact = sphere.exact || !scales_fit || !answers_fit || !plan.items.filter ||
                 !plan.conventions.valid.is_usual();  // the filter accepts every root >= 0
  return sphere;
}

const PairView* Visibility::Impl::pair_view() const {
  const bool has_pairs = plan.eye.scaling() == scene::Scaling{} && plan.items.filter &&
                         plan.conventions.valid.is_usual();
  if (!has_pairs) return nullptr;
  std::call_once(pair_view_made_, [this] { pair_view_.emplace(camera); });
  return &*pair_view_;
}

Blocks Visibility::Impl::bands_of(std::size_t sphere) const {
  const scene::PixelRectangle& pixels = plan.spheres[sphere].pixels;
  return blocks(pixels.j_begin, pixels.j_end, Tile::kHeight);
}

void Visibility::Impl::require_few_parts() const {
  if (plan.spheres.size() * band_count() <= kMostVisibleParts) return;
  std::uint64_t parts = 0;
  for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
    const Blocks its_bands = bands_of(k);
    if (!plan.spheres[k].pixels.empty()) parts += its_bands.last - its_bands.first;
  }
  if (parts <= kMostVisibleParts) return;
  throw std::invalid_argument("spheres: they cover " + std::to_string(parts) +
                              " bands of rows in all; visibility is computed for at most " +
                              std::to_string(kMostVisibleParts) + "; give fewer rows or spheres");
}

/// A reach is a range of distances. The spheres up to the end of the first cover the image about
/// kTimesOver times, those up to the end of each further one kGrowth times as often as before. The
/// estimate is from a sample of spheres.
void Visibility::Impl::set_reaches() {
  constexpr std::size_t kSamples = 4096;
  constexpr double kTimesOver = 32, kGrowth = 4;
  reach_end.fill(std::numeric_limits<double>::infinity());
  const std::size_t step = plan.spheres.size() / kSamples + 1;
  if (step == 1) return;
  std::vector<std::pair<double, std::size_t>> sample;
  for (std::size_t k = 0; k < plan.spheres.size(); k += step) {
    if (std::isfinite(plan.nearest_distance[k])) sample.emplace_back(plan.nearest_distance[k], k);
  }
  std::sort(sample.begin(), sample.end());
  double covered = 0, enough = kTimesOver * static_cast<double>(width * height);
  std::size_t reach = 0;
  for (const auto& [distance, k] : sample) {
    covered += static_cast<double>(step) * static_cast<double>(plan.spheres[k].pixels.count());
    if (covered < enough) continue;
    reach_end[reach++] = static_cast<double>(no_farther(distance));
    enough *= kGrowth;
    if (reach + 1 == kReaches) return;
  }
}

Lists Visibility::Impl::list_bands(double from, double to) const {
  std::vector<NearFirst> order;
  for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
    const double distance = plan.nearest_distance[k];
    if (distance < from || distance >= to) continue;
    order.push_back({std::bit_cast<std::uint32_t>(no_farther(distance)),
                     static_cast<std::uint32_t>(k), bands_of(k)});
  }
  scene::poll();
  sort(order);
  scene::poll();
  Lists lists;
  distribute(
      order.size(), band_count(), [&](std::size_t k) { return order[k].bands; },
      [&](std::size_t k) { return order[k].sphere; }, lists);
  return lists;
}

const Lists& Visibility::Impl::bands(std::size_t reach) const {
  std::call_once(bands_made_[reach], [this, reach] {
    bands_[reach] = list_bands(reach == 0 ? 0 : reach_end[reach - 1], reach_end[reach]);
  });
  return bands_[reach];
}

RowsInTiles::RowsInTiles(const Visibility::Impl& impl, std::int64_t j_begin, std::int64_t j_end)
    : impl_(impl), j_begin_(j_begin), j_end_(j_end) {
  if (j_begin < 0 || j_begin > j_end || j_end > impl.height) {
    throw std::invalid_argument("rows " + std::to_string(j_begin) + " to " + std::to_string(j_end) +
                                ": the image has " + std::to_string(impl.height));
  }
}

void RowsInTiles::require_fit(std::size_t size) const {
  if (size != 0 && size != pixels()) {
    throw std::invalid_argument("an array of " + std::to_string(size) + " for " +
                                std::to_string(pixels()) + " pixels");
  }
}

TileRectangle RowsInTiles::within_tile(const scene::PixelRectangle& pixels,
                                       std::size_t tile) const {
  const auto clamp = [](std::int64_t x, int low, int high) {
    return static_cast<int>(std::clamp<std::int64_t>(x, low, high));
  };
  const std::int64_t i = first_column(tile), j = first_row_;
  return {clamp(pixels.i_begin - i, 0, Tile::kWidth), clamp(pixels.i_end - i, 0, Tile::kWidth),
          clamp(pixels.j_begin - j, row_begin_, row_end_),
          clamp(pixels.j_end - j, row_begin_, row_end_)};
}

TileRays RowsInTiles::rays_of(std::size_t tile) const {
  TileRays rays;
  rays.alpha = impl_.alpha.data() + first_column(tile);
  const auto least = [](double x, double y) { return x * y <= 0 ? 0 : std::min(x * x, y * y); };
  const auto rows = std::min<std::int64_t>(Tile::kHeight, impl_.height - first_row_);
  for (std::int64_t row = 0; row < rows; ++row) {
    rays.beta[static_cast<std::size_t>(row)] =
        impl_.beta[static_cast<std::size_t>(first_row_ + row)];
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

Visibility::Visibility(scene::Scene scene, scene::ScenePlan plan)
    : impl_(std::make_unique<const Impl>(std::move(scene), std::move(plan))) {}
Visibility::~Visibility() = default;
Visibility::Visibility(Visibility&&) noexcept = default;

const scene::Scene& Visibility::scene() const { return impl_->scene; }
const scene::ScenePlan& Visibility::plan() const { return impl_->plan; }

DecidedBy Visibility::nearest(std::int64_t j_begin, std::int64_t j_end,
                              const SeenRows& rows) const {
  return nearest_of_rows(*impl_, j_begin, j_end, rows, Certified::kYes);
}

void Visibility::nearest_uncertified(std::int64_t j_begin, std::int64_t j_end,
                                     const SeenRows& rows) const {
  nearest_of_rows(*impl_, j_begin, j_end, rows, Certified::kNo);
}

DecidedBy Visibility::classes(std::size_t sphere, std::int64_t j_begin, std::int64_t j_end,
                              std::span<HitClass> classes) const {
  return classes_of_rows(*impl_, sphere, j_begin, j_end, classes);
}

DecidedBy& DecidedBy::operator+=(const DecidedBy& other) {
  filter += other.filter;
  for (std::size_t k = 0; k < stages.size(); ++k) stages[k] += other.stages[k];
  return *this;
}

}  // namespace raycheck::reference
