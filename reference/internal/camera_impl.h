#pragma once

// The data of an ExactCamera. Internal to reference/.

#include "reference/exact_camera.h"
#include "reference/internal/formulas.h"
#include "reference/internal/kept.h"
#include "reference/internal/quick_line.h"
#include "reference/internal/rounding.h"

namespace raycheck::reference {

/// The precision of the filter stage of balls, between double-doubles and the exact field.
inline constexpr int kMiddleBits = 256;

/// A camera under each kernel. It depends on neither the conventions nor the size of the image, so
/// that cameras that differ only in these share it.
class CameraStages {
 public:
  explicit CameraStages(const scene::Camera& its_camera);

  /// Calls use(camera) with the camera at a precision. Cameras of the two usual precisions are
  /// kept.
  template <class Use>
  auto enclosed(const EnclosureLift& lift, Use use) const {
    if (lift.relative_change == 0 && lift.bits == kFirstBits) return use(first_bits());
    if (lift.relative_change == 0 && lift.bits == kMiddleBits) return use(middle_bits());
    return use(camera_numbers(lift, camera));
  }

  // Made on demand, since doubles nearly always decide.
  const CameraNumbers<DoubleDoubleKernel>& double_doubles() const;
  const CameraNumbers<ExactKernel>& exact() const;

  const scene::Camera camera;  ///< The size of its image does not matter.
  const CameraNumbers<IntervalKernel> intervals;
  const QuickAxes quick;

 private:
  const CameraNumbers<EnclosureKernel>& first_bits() const;
  const CameraNumbers<EnclosureKernel>& middle_bits() const;

  OnDemand<CameraNumbers<DoubleDoubleKernel>> double_doubles_;
  OnDemand<CameraNumbers<EnclosureKernel>> first_bits_, middle_bits_;
  OnDemand<CameraNumbers<ExactKernel>> exact_;
};

struct ExactCamera::Impl {
  scene::Camera camera;
  scene::Conventions conventions;
  std::shared_ptr<const CameraStages> stages;
};

/// Throws std::invalid_argument if the pixel is outside the camera's image.
void require_pixel_of(const scene::Camera& camera, const scene::Pixel& pixel);

inline Enclosure3 coordinates(const EnclosureKernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace raycheck::reference
