#pragma once

#include <memory>

#include "reference/enclosure.h"
#include "reference/internal/double_double.h"
#include "reference/internal/triple.h"
#include "scene/camera.h"
#include "scene/conventions.h"
#include "scene/geometry.h"
#include "scene/precision.h"

namespace raycheck::reference {

struct EnclosedFrame {
  Enclosure3 U, V, W;
};

struct RoundedFrame {
  scene::UnitVector3 U, V, W;
};

struct DoubleDoubleFrame {
  Triple<DoubleDouble> U, V, W;
};

/// A camera, known exactly. It is made once per scene, and may be read from all threads.
/// Domain: a camera without defects under `conventions` (scene/validate.h); otherwise throws
///         std::invalid_argument naming the field.
/// Error:  that of ExactRay.
class ExactCamera {
 public:
  struct Impl;
  ExactCamera(const scene::Camera& camera, const scene::Conventions& conventions);

  const scene::Camera& camera() const;
  const scene::Conventions& conventions() const;

  /// The axes. Each coordinate has the relative width 2^-relative_bits; a coordinate of 0 is exact.
  EnclosedFrame frame(int relative_bits = 70) const;
  RoundedFrame rounded_frame(scene::Precision precision = scene::Precision::kDouble) const;
  DoubleDoubleFrame frame_in_double_doubles() const;
  /// alpha(i) and beta(j) of a pixel, with `near` as the third coordinate.
  Enclosure3 plane_position(const scene::Pixel& pixel, int bits = 256) const;
  Triple<DoubleDouble> plane_position_in_double_doubles(const scene::Pixel& pixel) const;

  const std::shared_ptr<const Impl>& impl() const { return impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace raycheck::reference
