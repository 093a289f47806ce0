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

/// Replace the sphere, s and the coordinates of Q if the pixel's ray misses all spheres.
inline constexpr std::int32_t kNoSphere = -1;
inline constexpr double kNoParameter = std::numeric_limits<double>::infinity();

/// The nearest hits of pixels, row by row. Empty arrays are not filled.
struct SeenRows {
  std::span<std::int32_t> sphere;  ///< The nearest sphere; of several at the same s, the first.
  std::span<double> parameter;     ///< s
  std::span<double> point_x, point_y, point_z;  ///< Q. Either all three are empty or none is.
  /// The number of spheres at this s, without those that the plan leaves out; 0: none.
  std::span<std::int32_t> ties = {};
};

/// The numbers of pixels decided by the filter and by each stage.
struct DecidedBy {
  std::uint64_t filter = 0;  ///< Decided by doubles, with bounds on their errors.
  /// The pixels for each highest stage that a decision needed (index: FilterStage), of ExactRay or
  /// of the filter in double-doubles.
  std::array<std::uint64_t, 4> stages{};

  std::uint64_t fallback() const { return stages[0] + stages[1] + stages[2] + stages[3]; }
  DecidedBy& operator+=(const DecidedBy& other);
  bool operator==(const DecidedBy&) const = default;
};

/// The nearest hits of an image's pixels. All decisions are right: hit or miss, in front or behind,
/// which sphere is nearer.
/// Shape:  rows j_begin <= j < j_end of a camera's image -> one answer per pixel, in (j, i) order.
/// Units:  scene lengths.
/// Domain: doubles that round to nearest; the scene of the plan (another scene is not detected),
///         with fewer than 2^31 spheres. Throws std::invalid_argument if an array has the wrong
///         size, or the image has more than kMostVisibleSide columns or rows (naming the camera's
///         field).
/// Memory: about 100 bytes per column and row, and up to kMostVisibleParts list entries.
/// Error:  no decision is wrong. A tangent counts as a hit unless the convention is `miss`. s is
///         off by at most kVisibleParameterError |Q - E| plus the least double: far from
///         silhouettes, by a few u of |Q - E|; if an exact ray decided, s is correctly rounded.
///         Each coordinate of Q is off by at most kVisibleParameterError |Q - E| + 4u |Q| plus the
///         least double.
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
  /// The nearest sphere by the filter's doubles only, right or wrong. Its time is the baseline for
  /// the cost of certainty.
  void nearest_uncertified(std::int64_t j_begin, std::int64_t j_end, const SeenRows& rows) const;
  /// The hit class of one sphere at every pixel.
  DecidedBy classes(std::size_t sphere, std::int64_t j_begin, std::int64_t j_end,
                    std::span<HitClass> classes) const;

  /// The number of rows that are decided together. Calls for multiples of it are fastest.
  static constexpr std::int64_t kBandRows = 16;

 private:
  std::unique_ptr<const Impl> impl_;
};

/// The largest error of s, without the least double, as a share of the distance of the hit point
/// from the eye.
inline constexpr double kVisibleParameterError = 0x1p-20;

/// The largest number of columns or rows, which need 100 MiB.
inline constexpr std::int64_t kMostVisibleSide = std::int64_t{1} << 22;
/// The largest total length of the lists of all bands of kBandRows rows. A sphere is listed in
/// every band that it reaches.
inline constexpr std::uint64_t kMostVisibleParts = std::uint64_t{1} << 27;

}  // namespace raycheck::reference
