#pragma once

#include "fast/domain.h"
#include "scene/camera.h"
#include "scene/geometry.h"

namespace raycheck::fast {

/// The largest relative error of an axis, in units of u = 2^-53, while the axes' condition number
/// is at most kModerateCondition (properties/quantity.h), growing in proportion beyond.
inline constexpr double kFrameMaxUlp = 64;

/// How far the axes are from orthonormal, in units of u, whatever their condition number is: the
/// largest | |X| - 1 | of an axis, or |X.Y| of two.
inline constexpr double kFrameMaxDefectUlp = 8;

struct CameraFrame {
  scene::UnitVector3 U, V, W;
};

/// The camera axes.
/// Shape:  one camera -> three unit vectors, orthonormal and right-handed but for rounding.
/// Units:  none.
/// Domain: a valid camera (scene/validate.h), otherwise throws std::invalid_argument naming the
///         field; lengths between kSmallestLength and kLargestLength, otherwise squares over- or
///         underflow silently.
/// Error:  at most kFrameMaxUlp u in each axis; kFrameMaxDefectUlp u between them.
/// Source: the lecture: W = (E - A)/|E - A|, U = (up x W)/|up x W|, V = W x U.
CameraFrame camera_frame(const scene::Camera& camera);

}  // namespace raycheck::fast
