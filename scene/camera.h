#pragma once

#include <cstdint>
#include <optional>

#include "scene/geometry.h"

namespace raycheck::scene {

/// A camera as in the lecture: W = (eye - look_at) normalised, U = up x W normalised, V = W x U.
/// Lengths are scene lengths. near and far are signed positions along W, negative in front of the
/// eye. The image plane is at near, from left to right along U and from bottom to top along V;
/// left > right or bottom > top mirrors the image.
struct Camera {
  Point3 eye;
  Point3 look_at;
  Vector3 up;
  double near = 0;
  std::optional<double> far;  ///< Not used in any formula; kept because some files state it.
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  std::int64_t width = 0;   ///< Pixels across.
  std::int64_t height = 0;  ///< Pixels down.
  bool operator==(const Camera&) const = default;
};

/// The largest width and height of an image; the index of a pixel in the image then fits 64 bits.
inline constexpr std::int64_t kMostPixelsAcross = (std::int64_t{1} << 31) - 1;

/// The pixel in column i and row j; the `rows` convention says which row is j = 0.
struct Pixel {
  std::int64_t i = 0;
  std::int64_t j = 0;
  bool operator==(const Pixel&) const = default;
};

}  // namespace raycheck::scene
