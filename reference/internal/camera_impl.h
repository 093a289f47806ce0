#pragma once

// The data of an ExactCamera. Internal to reference/.

#include "reference/exact_camera.h"
#include "reference/internal/formulas.h"
#include "reference/internal/quick_line.h"
#include "reference/internal/rounding.h"
#include "scene/on_demand.h"

namespace raycheck::reference {

/// The precision of the filter stage of balls, between double-doubles and the exact field.
inline constexpr int kMiddleBits = 256;

struct ExactCamera::Impl {
  Impl(const scene::Camera& its_camera, const scene::Conventions& its_conventions);

  /// Calls use(camera) with the camera at a precision. Cameras of the two usual precisions are
  /// kept.
  template <class Use>
  auto enclosed(const EnclosureLift& lift, Use use) const {
    if (lift.relative_change == 0 && lift.bits == kFirstBits) return use(first_bits());
    if (lift.relative_change == 0 && lift.bits == kMiddleBits) return use(middle_bits());
    return use(camera_numbers(lift, camera));
  }

  // Made on demand, since intervals nearly always decide.
  const CameraNumbers<DoubleDoubleKernel>& double_doubles() const;
  const CameraNumbers<ExactKernel>& exact() const;

  scene::Camera camera;
  scene::Conventions conventions;
  CameraNumbers<IntervalKernel> intervals;
  QuickAxes quick;

 private:
  const CameraNumbers<EnclosureKernel>& first_bits() const;
  const CameraNumbers<EnclosureKernel>& middle_bits() const;

  scene::OnDemand<CameraNumbers<DoubleDoubleKernel>> double_doubles_;
  scene::OnDemand<CameraNumbers<EnclosureKernel>> first_bits_, middle_bits_;
  scene::OnDemand<CameraNumbers<ExactKernel>> exact_;
};

/// Throws std::invalid_argument if the pixel is outside the camera's image.
void require_pixel_of(const scene::Camera& camera, const scene::Pixel& pixel);

inline Enclosure3 coordinates(const EnclosureKernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace raycheck::reference
