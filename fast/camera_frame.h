#pragma once

#include "fast/domain.h"
#include "scene/camera.h"
#include "scene/geometry.h"

namespace raycheck::fast {

/// The largest relative error of an axis, in units of u = 2^-53, up to a condition number of
/// kModerateCondition (properties/quantity.h). Above, it grows in proportion to the condition
/// number.
inline constexpr double kFrameMaxUlp = 64;

/// The largest | |X| - 1 | of an axis and |X.Y| of two axes, in units of u, for every condition
/// number.
inline constexpr double kFrameMaxDefectUlp = 8;

struct CameraFrame {
  scene::UnitVector3 U, V, W;
};

/// The camera axes.
/// Shape:  one camera -> three vectors, orthonormal up to rounding, right-handed.
/// Units:  none.
/// Domain: a valid camera (scene/validate.h), otherwise throws std::invalid_argument naming the
///         field; lengths between kSmallestLength and kLargestLength, otherwise squares over- or
///         underflow silently.
/// Error:  at most kFrameMaxUlp u in each axis; at most kFrameMaxDefectUlp u from orthonormal.
/// Source: the lecture: W = (E - A)/|E - A|, U = (up x W)/|up x W|, V = W x U.
CameraFrame camera_frame(const scene::Camera& camera);

}  // namespace raycheck::fast
