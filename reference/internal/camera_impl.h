#pragma once

// What an ExactCamera holds. Internal to reference/.

#include "reference/exact_camera.h"
#include "reference/internal/formulas.h"
#include "reference/internal/kept.h"
#include "reference/internal/rounding.h"

namespace raycheck::reference {

/// The precision of the ladder's middle rung, between intervals and the exact field.
inline constexpr int kMiddleBits = 256;

struct ExactCamera::Impl {
  Impl(const scene::Camera& its_camera, const scene::Conventions& its_conventions);

  /// The camera at any precision: kept for the two usual ones.
  CameraNumbers<EnclosureKernel> enclosed(const EnclosureLift& lift) const;

  /// In the exact field, which intervals nearly always spare.
  const CameraNumbers<ExactKernel>& exact() const;

  scene::Camera camera;
  scene::Conventions conventions;
  CameraNumbers<EnclosureKernel> middle_bits;
  CameraNumbers<IntervalKernel> intervals;
  CameraNumbers<DoubleDoubleKernel> double_doubles;

 private:
  OnDemand<CameraNumbers<EnclosureKernel>> first_bits_;
  OnDemand<CameraNumbers<ExactKernel>> exact_;
};

/// Throws std::invalid_argument unless the camera's image has the pixel.
void require_pixel_of(const scene::Camera& camera, const scene::Pixel& pixel);

inline Enclosure3 coordinates(const EnclosureKernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace raycheck::reference
