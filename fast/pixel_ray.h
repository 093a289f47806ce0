#pragma once

#include <span>
#include <string_view>

#include "fast/batch.h"
#include "fast/domain.h"
#include "fast/method_list.h"
#include "scene/camera.h"
#include "scene/conventions.h"

namespace raycheck::fast {

/// A way to make the rays of a camera's pixels. All methods share one contract:
/// Shape:  one camera, N pixels -> N points, or N rays; outputs are resized to N.
/// Units:  scene lengths; directions are unit.
/// Domain: a valid camera (under the rows and samples of `conventions`); otherwise throws
///         std::invalid_argument naming the field. Pixels inside the image. Nonzero lengths inside
///         `domain`; otherwise intermediate values over- or underflow silently.
/// Error:  at most max_point_ulp u in a point (relative error) and max_direction_ulp u in a
///         direction (angle), up to condition numbers of kModerateCondition
///         (properties/quantity.h); above, both bounds grow in proportion to the condition number.
///         |D| differs from 1 by at most max_unit_defect_ulp u. A method's `not_kept` names the
///         inputs without these bounds. A missing function is null.
struct PixelRayMethod {
  using MakePoints = void (*)(const scene::Camera&, const scene::Conventions&,
                              std::span<const scene::Pixel>, Vectors&);
  using MakeRays = void (*)(const scene::Camera&, const scene::Conventions&,
                            std::span<const scene::Pixel>, Rays&);

  std::string_view name;
  std::string_view sentence;
  MakePoints pixel_points;  ///< P
  MakeRays pixel_rays;      ///< from P along D
  MakeRays focal_rays;      ///< from E along D
  // The bounds, which `raycheck properties` checks.
  double max_point_ulp;
  double max_direction_ulp;
  double max_unit_defect_ulp;
  std::string_view not_kept = {};  ///< The inputs without these bounds; a test covers them.
  Domain domain = {};
  double unit_roundoff = 0x1p-53;  ///< u of the arithmetic that it uses.
};

#define RAYCHECK_DECLARE(name) extern const PixelRayMethod k##name##Rays;
RAYCHECK_PIXEL_RAY_METHODS(RAYCHECK_DECLARE)
#undef RAYCHECK_DECLARE

/// A pixel's position on the image plane: alpha along U, beta along V, as every method computes it.
struct PlanePosition {
  double alpha;
  double beta;
};
PlanePosition plane_position(const scene::Camera& camera, const scene::Conventions& conventions,
                             const scene::Pixel& pixel);

/// Every method, in the order of reports.
std::span<const PixelRayMethod* const> pixel_ray_methods();

}  // namespace raycheck::fast
