#ifndef RAYCHECK_FAST_PIXEL_RAY_H_
#define RAYCHECK_FAST_PIXEL_RAY_H_

#include <cstdint>
#include <span>
#include <string_view>

#include "fast/batch.h"
#include "fast/domain.h"
#include "scene/camera.h"
#include "scene/conventions.h"

namespace raycheck::fast {

/// A way to make the rays of a camera's pixels. All methods share one contract:
/// Shape:  one camera, N pixels -> N points, or N rays; outputs are resized to N.
/// Units:  scene lengths; directions are unit.
/// Domain: a valid camera (under the rows and samples of `conventions`, otherwise
///         std::invalid_argument naming the field), pixels inside the image; nonzero
///         lengths inside `domain`, otherwise intermediate values over- or underflow silently.
/// Error:  at most max_point_ulp in a point and max_direction_ulp in a direction (relative error
///         and angle, in units of u) while their condition numbers are at most kModerateCondition
///         (properties/quantity.h), growing in proportion beyond. |D| differs from 1 by at most
///         max_unit_defect_ulp u.
///         A method's `not_kept` says where it does not keep its bounds.
/// A function that a method does not have is null.
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
  double max_point_ulp;
  double max_direction_ulp;
  double max_unit_defect_ulp;
  std::string_view not_kept = {};  ///< Where it does not keep them (a test pins that).
  Domain domain = {};
  double unit_roundoff = 0x1p-53;  ///< Of the arithmetic that it computes in.
};

// The bounds of all methods; audited by the campaigns of `raycheck properties`.
inline constexpr double kPixelPointMaxUlp = 128;
inline constexpr double kLectureDirectionMaxUlp = 64;  ///< P - E cancels where |E| is large.
inline constexpr double kDirectDirectionMaxUlp = 64;
inline constexpr double kUnitDefectMaxUlp = 4;
inline constexpr double kFocalUnitDefectMaxUlp = 8;     ///< It takes the axes for orthonormal.
inline constexpr double kIncrementalPointMaxUlp = 256;  ///< kIncrementalTile additions.
inline constexpr double kIncrementalDirectionMaxUlp = 256;
inline constexpr double kSinglePointMaxUlp = 56 * 0x1p29;
inline constexpr double kSingleDirectionMaxUlp = 256 * 0x1p29;
inline constexpr double kSingleUnitDefectMaxUlp = 4 * 0x1p29;

/// How many pixels of a row `incremental` steps over before it starts anew, by multiplication, as a
/// renderer in tiles does. A pixel's answer then depends on its column alone, not on which pixels
/// are asked for; a batch in the order of rows costs an addition a pixel.
inline constexpr std::int64_t kIncrementalTile = 64;

/// `lecture`: literally P = E + n W + alpha U + beta V, then D = (P - E)/|P - E|.
extern const PixelRayMethod kLectureRays;
/// `direct`: D from g = n W + alpha U + beta V, so that E's size does not touch it; P = E + g.
extern const PixelRayMethod kDirectRays;
/// `focal`: rays from E only, with all that the pixels share computed once per scene.
extern const PixelRayMethod kFocalRays;
/// `incremental`: `direct` with g stepped along a row by du = (right - left)/(w-1) U;
/// kIncrementalTile.
extern const PixelRayMethod kIncrementalRays;
/// `single`: `direct` in single precision, axes included; lengths are in kSingleDomain.
extern const PixelRayMethod kSingleRays;

/// Where on the image plane a pixel is: alpha along U, beta along V, as every method computes them.
struct PlanePosition {
  double alpha;
  double beta;
};
PlanePosition plane_position(const scene::Camera& camera, const scene::Conventions& conventions,
                             const scene::Pixel& pixel);

/// Every method, in the order of reports.
std::span<const PixelRayMethod* const> pixel_ray_methods();

}  // namespace raycheck::fast

#endif  // RAYCHECK_FAST_PIXEL_RAY_H_
