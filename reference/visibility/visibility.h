#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "reference/exact_ray.h"
#include "scene/plan/plan.h"
#include "scene/scene.h"

namespace raycheck::reference {

/// In place of a sphere, of s and of Q's coordinates: the pixel's ray meets none.
inline constexpr std::int32_t kNoSphere = -1;
inline constexpr double kNoParameter = std::numeric_limits<double>::infinity();

/// The nearest hits of pixels, row by row; empty arrays are not filled.
struct SeenRows {
  std::span<std::int32_t> sphere;  ///< The nearest sphere; the first in the file if several tie.
  std::span<double> parameter;     ///< s
  std::span<double> point_x, point_y, point_z;  ///< Q, all or none of them.
};

/// The numbers of pixels decided by the filter and by each stage.
struct DecidedBy {
  std::uint64_t filter = 0;  ///< Doubles, within bounds on their errors.
  /// By the highest stage that a pixel's decisions needed (index: FilterStage): of ExactRay, or the
  /// filter once more in double-doubles.
  std::array<std::uint64_t, 4> stages{};

  std::uint64_t fallback() const { return stages[0] + stages[1] + stages[2] + stages[3]; }
  DecidedBy& operator+=(const DecidedBy& other);
  bool operator==(const DecidedBy&) const = default;
};

/// The nearest hits of an image's pixels, with every decision right: hit or miss, in front or
/// behind, which sphere is nearer.
/// Shape:  rows j_begin <= j < j_end of a camera's image -> one answer per pixel, in (j, i) order.
/// Units:  scene lengths.
/// Domain: doubles that round to nearest; the scene that the plan was made for (another one is not
///         detected), with fewer than 2^31 spheres. Arrays of the wrong size throw
///         std::invalid_argument, as do, naming the camera's field, more than kMostVisibleSide
///         columns or rows.
/// Memory: some 100 bytes per column and row, and up to kMostVisibleParts list entries.
/// Error:  no decision is wrong. A tangent counts as a hit unless the convention is `miss`. s is
///         within kVisibleParameterError |Q - E| and the least double, within a few u of |Q - E|
///         far from silhouettes, and correctly rounded where an exact ray decided; Q is within
///         kVisibleParameterError |Q - E| + 4u |Q| and the least double per coordinate.
/// Thread safety: const functions may be called from several threads.
/// Source: reference/internal/formulas.h; the filter's bound is proved in
/// reference/visibility/visibility_kernel.h.
class Visibility {
 public:
  struct Impl;

  Visibility(scene::Scene scene, scene::ScenePlan plan);
  ~Visibility();
  Visibility(Visibility&&) noexcept;

  const scene::Scene& scene() const;
  const scene::ScenePlan& plan() const;

  /// The nearest sphere of every pixel.
  DecidedBy nearest(std::int64_t j_begin, std::int64_t j_end, const SeenRows& rows) const;
  /// The same without certificates: the filter's doubles, right or wrong. The baseline for the cost
  /// of certainty.
  void nearest_uncertified(std::int64_t j_begin, std::int64_t j_end, const SeenRows& rows) const;
  /// The class of every pixel against one sphere.
  DecidedBy classes(std::size_t sphere, std::int64_t j_begin, std::int64_t j_end,
                    std::span<HitClass> classes) const;

  /// The number of rows that are decided together: calls for multiples of it cost least.
  static constexpr std::int64_t kBandRows = 16;

 private:
  std::unique_ptr<const Impl> impl_;
};

/// The largest error of s, but for the least double, as a share of the distance between the eye and
/// the hit point.
inline constexpr double kVisibleParameterError = 0x1p-20;

/// The most columns, or rows: they take 100 MiB.
inline constexpr std::int64_t kMostVisibleSide = std::int64_t{1} << 22;
/// Spheres are listed in every band of kBandRows rows that they reach; this is the largest total
/// length of the lists.
inline constexpr std::uint64_t kMostVisibleParts = std::uint64_t{1} << 27;

}  // namespace raycheck::reference
