#ifndef RAYCHECK_PROPERTIES_LAWS_LAW_LIST_H_
#define RAYCHECK_PROPERTIES_LAWS_LAW_LIST_H_

// The laws by subject, each defined in the file of that name. Internal to properties/.

#include "properties/laws/law.h"

namespace raycheck::properties {

extern const Law kFrameLaw;  // camera_frame.cpp

extern const Law kPixelPointLaw;  // pixel_plane.cpp
extern const Law kBoundsLaw;
extern const Law kImagePlaneLaw;
extern const Law kCentrePixelLaw;
extern const Law kPixelZeroZeroLaw;
extern const Law kDensityLaw;
extern const Law kSquarePixelsLaw;

extern const Law kUnitDirectionLaw;  // pixel_ray.cpp
extern const Law kDirectionLaw;
extern const Law kRayOriginLaw;

extern const Law kClassLaw;  // intersect.cpp
extern const Law kRootLaw;
extern const Law kParameterLaw;
extern const Law kBackwardErrorLaw;
extern const Law kHitPointLaw;
extern const Law kFocalAndPixelLaw;

extern const Law kImageLaw;          // image_law.cpp
extern const Law kNearestSphereLaw;  // nearest_sphere.cpp
extern const Law kVisibleSphereLaw;

extern const Law kPlanLeftOutLaw;  // scene_plan.cpp
extern const Law kPlanRectanglesLaw;
extern const Law kPlanRootsLaw;

extern const Law kScalingLaw;  // invariance.cpp
extern const Law kAxesLaw;
extern const Law kLookAtLaw;
extern const Law kUpLaw;
extern const Law kGrowingRadiusLaw;

extern const Law kRefusalLaw;  // refusal.cpp

/// The coordinates as a list, for reports.
template <class Triple>
std::vector<double> numbers(const Triple& value) {
  return {value.x, value.y, value.z};
}

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_LAWS_LAW_LIST_H_
