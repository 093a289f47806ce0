#pragma once

// The inputs of the filter of certified visibility in double-doubles. Internal to reference/.

#include <cstddef>
#include <cstdint>

#include "reference/exact_camera.h"
#include "reference/visibility/visibility_bound.h"
#include "reference/visibility/visibility_kernel.h"
#include "scene/scene.h"

namespace raycheck::reference {

/// The positions of columns or rows along an axis of the image plane.
struct PairAxis {
  DoubleDouble first, step;  ///< position = first + index step
  double turned;             ///< The sum of a pixel's indices from either end.
  double count;
  double most;  ///< The largest |position|.

  PairAxis(double low, double high, std::int64_t pixels, scene::Samples samples);
  /// The largest error of a computed position.
  double doubt() const;
};

/// A camera in double-doubles.
/// Domain: magnitudes that need no scaling (scene::kPlainExponent).
class PairView {
 public:
  explicit PairView(const ExactCamera& camera);

  const PlaneSizes& sizes() const { return sizes_; }
  FilteredSphereOf<Pair> sphere(const scene::Sphere& sphere, std::size_t index) const;
  /// The rays of a tile in pairs, from the first column and row on; `same` has these rays in
  /// doubles.
  PairRays rays(const TileRays& same, std::int64_t first_column, std::int64_t first_row) const;

 private:
  scene::Camera camera_;
  DoubleDoubleFrame frame_;
  PairAxis columns_, rows_;
  bool is_top_first_;
  PlaneSizes sizes_;
};

}  // namespace raycheck::reference
